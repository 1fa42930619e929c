; No node is captured twice, so that it does not matter whether an editor lets the first or the last pattern win.

(comment) @comment
(doc_comment) @comment.documentation

(number) @number
(unknown) @constant.builtin
(unit) @string.special.unit
; Titles and layouts; paths stand below.
(mode title: (text) @string)
(field value: (text) @string)
(import path: (text) @string.special.path)
(survey path: (text) @string.special.path)

; ---- words

["use" "waypoints" "from"] @keyword.import

[
  "let" "require" "vehicle" "faults" "mission" "plan" "simulate" "campaign" "limits" "keep_in" "keep_out" "mode" "every" "curve" "rotor"
  "rotors" "battery" "air" "start" "end" "moving" "waypoint" "hold" "fault" "where" "in" "as" "reduced" "to" "stuck" "at" "towards" "along" "path" "free"
] @keyword

(lost) @keyword
(clause_word) @keyword

; ---- names

(vehicle name: (name) @type)
(mission name: (name) @type)
(mode name: (name) @constant)
(every name: (name) @constant)
(strike mode: (name) @constant)
(volume name: (name) @label)
(waypoint name: (name) @label)
(binding name: (name) @variable)
(curve parameter: (name) @variable.parameter)

(field name: (name) @property)
(limit name: (name) @property)
(filter name: (name) @property)
(requirement name: (name) @property)

((call function: (name) @function.builtin)
  (#any-of? @function.builtin "sin" "cos" "tan" "asin" "acos" "atan" "atan2" "sqrt" "abs" "min" "max"))

((reference (name) @constant.builtin)
  (#any-of? @constant.builtin "pi" "g0"))

; Words that some fields take.
((field value: (reference (name) @constant.builtin))
  (#any-of? @constant.builtin
    "all" "always" "bounded" "box" "continue" "cylinder" "distance" "estimator" "exact" "geometric" "half_space" "hold"
    "hover" "instant" "lagging" "land" "minimum" "never" "off" "optimal" "pd" "polygon" "proportional"
    "pseudo_inverse" "rcp" "rip" "rsp" "sphere" "uniform" "where_needed"))
((field value: (list (reference (name) @constant.builtin)))
  (#any-of? @constant.builtin "rcp" "rip" "rsp"))
((clause value: (reference (name) @constant.builtin))
  (#any-of? @constant.builtin "P" "N"))

; ---- marks

["=" "<=" ">=" "<" ">" ".." "+-" "+" "-" "*" "/" "^"] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ";"] @punctuation.delimiter
