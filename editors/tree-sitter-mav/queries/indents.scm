; In Helix's words.

[
  (body)
  (list)
  (parenthesized)
  (call)
] @indent

["}" "]" ")"] @outdent
