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

; ---- words, those between marks written from the table of the language (CONTRIBUTING.md)

["use" "waypoints" "from"] @keyword.import

[
  ; words: statements of the spec
  "after_fault_limits" "air" "battery" "campaign" "curve" "end" "every" "faults" "fault" "hold" "keep_in" "keep_off"
  "keep_out" "landing_site" "let" "limits" "mission" "mode" "parts" "part" "plan" "recovery" "require" "rotors"
  "rotor" "simulate" "start" "vehicle" "waypoint"
  ; end of words
  "moving" "where" "in" "as" "reduced" "to" "stuck" "at" "towards" "along" "path" "free"
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
(landing_site name: (name) @label)
(part name: (name) @label)
(waypoint name: (name) @label)
(binding name: (name) @variable)
(curve parameter: (name) @variable.parameter)

(field name: (name) @property)
(limit name: (name) @property)
(filter name: (name) @property)
(requirement name: (name) @property)

((call function: (name) @function.builtin)
  (#any-of? @function.builtin
    ; words: functions
    "abs" "acos" "asin" "atan2" "atan" "cos" "max" "min" "sin" "sqrt" "tan"
    ; end of words
  ))

((reference (name) @constant.builtin)
  (#any-of? @constant.builtin
    ; words: constants
    "g0" "pi"
    ; end of words
  ))

; Words that some fields take.
((field value: (reference (name) @constant.builtin))
  (#any-of? @constant.builtin
    ; words: values of fields
    "all" "always" "bounded" "box" "continue" "cylinder" "distance" "drawn" "estimated" "estimator" "exact"
    "geometric" "half_space" "hold" "hover" "instant" "lagging" "land" "middle" "minimum" "never" "normal" "off"
    "optimal" "pd" "polygon" "proportional" "pseudo_inverse" "quick" "rcp" "recovery" "rip" "rsp" "sphere" "thorough"
    "uniform" "where_needed"
    ; end of words
  ))
((field value: (list (reference (name) @constant.builtin)))
  (#any-of? @constant.builtin
    ; words: values in lists
    "continue" "land_at_sites" "land_here" "rcp" "rip" "rsp"
    ; end of words
  ))
((clause value: (reference (name) @constant.builtin))
  (#any-of? @constant.builtin
    ; words: values of clauses
    "N" "P"
    ; end of words
  ))

; ---- marks

["=" "<=" ">=" "<" ">" ".." "+-" "+" "-" "*" "/" "^"] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ";"] @punctuation.delimiter
