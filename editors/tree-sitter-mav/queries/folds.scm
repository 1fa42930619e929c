[
  (body)
  (list)
  (parenthesized)
  (call)
] @fold
