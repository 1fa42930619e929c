(body "}" @end) @indent
(list "]" @end) @indent
(parenthesized ")" @end) @indent
