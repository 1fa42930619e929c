;;; mav-ts-mode.el --- Specs of multirotor missions that must survive rotor faults  -*- lexical-binding: t; -*-

;; Needs Emacs 29 with tree-sitter and the grammar of editors/tree-sitter-mav as libtree-sitter-mav: see
;; docs/editors/emacs.md.  The words between marks are written from the table of the language (CONTRIBUTING.md).

(require 'treesit)
(require 'eglot)

(defvar mav-ts-mode--font-lock
  (treesit-font-lock-rules
   :language 'mav :feature 'comment
   '([(comment) (doc_comment)] @font-lock-comment-face)
   :language 'mav :feature 'string
   '((text) @font-lock-string-face)
   :language 'mav :feature 'keyword
   '(([
       ;; words: statements
       "after_fault_limits" "air" "battery" "campaign" "curve" "end" "every" "faults" "fault" "hold" "keep_in"
       "keep_off" "keep_out" "landing_site" "let" "limits" "mission" "mode" "parts" "part" "plan" "recovery" "require"
       "rotors" "rotor" "simulate" "start" "use" "vehicle" "waypoints" "waypoint"
       ;; end of words
       "moving" "from" "where" "in" "as" "reduced" "to" "stuck" "at" "towards" "along" "path" "free"]
      @font-lock-keyword-face)
     [(lost) (clause_word)] @font-lock-keyword-face)
   :language 'mav :feature 'definition
   '((vehicle name: (name) @font-lock-type-face)
     (mission name: (name) @font-lock-type-face)
     (volume name: (name) @font-lock-constant-face)
     (landing_site name: (name) @font-lock-constant-face)
     (part name: (name) @font-lock-constant-face)
     (mode name: (name) @font-lock-constant-face)
     (every name: (name) @font-lock-constant-face)
     (binding name: (name) @font-lock-variable-name-face))
   :language 'mav :feature 'property
   '([(field name: (name) @font-lock-property-name-face)
      (limit name: (name) @font-lock-property-name-face)
      (filter name: (name) @font-lock-property-use-face)
      (requirement name: (name) @font-lock-property-name-face)])
   :language 'mav :feature 'number
   '((number) @font-lock-number-face
     (unit) @font-lock-type-face)
   :language 'mav :feature 'function
   '((call function: (name) @font-lock-function-call-face)))
  "What stands out, by feature.")

(defvar mav-ts-mode--indent
  '((mav
     ((node-is "[])}]") parent-bol 0)
     ((parent-is "body") parent-bol 4)
     ((parent-is "list") parent-bol 4)
     ((parent-is "parenthesized") parent-bol 4)
     ((parent-is "call") parent-bol 4)
     ((parent-is "source_file") column-0 0)))
  "Four blanks a bracket.")

(defun mav-ts-mode--name (node)
  "What the block at NODE is called."
  (treesit-node-text (treesit-node-child-by-field-name node "name") t))

(defun mav-ts-mode--block-p (node)
  "Whether NODE is a block, rather than the word of the same type that begins it."
  (treesit-node-check node 'named))

(defvar mav-ts-mode--imenu
  (mapcar (lambda (kind) (list (car kind) (cdr kind) #'mav-ts-mode--block-p nil))
          '(("Vehicle" . "\\`vehicle\\'") ("Mission" . "\\`mission\\'") ("Fault mode" . "\\`\\(?:mode\\|every\\)\\'")))
  "What has a name.")

;;;###autoload
(define-derived-mode mav-ts-mode prog-mode "mav"
  "Specs of multirotor missions that must survive rotor faults."
  (setq-local comment-start "// " comment-end "" indent-tabs-mode nil)
  (when (treesit-ready-p 'mav)
    (treesit-parser-create 'mav)
    (setq-local treesit-defun-type-regexp '("\\`\\(?:vehicle\\|mission\\|mode\\|every\\)\\'" . mav-ts-mode--block-p)
                treesit-defun-name-function #'mav-ts-mode--name
                treesit-font-lock-settings mav-ts-mode--font-lock
                treesit-font-lock-feature-list '((comment definition) (keyword string) (number property) (function))
                treesit-simple-indent-rules mav-ts-mode--indent
                treesit-simple-imenu-settings mav-ts-mode--imenu)
    (treesit-major-mode-setup)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.mav\\'" . mav-ts-mode))
(add-to-list 'eglot-server-programs '(mav-ts-mode . ("mavc" "lsp")))

(provide 'mav-ts-mode)
;;; mav-ts-mode.el ends here
