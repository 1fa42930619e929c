// What the mav grammar cannot tell from one token alone: src/syntax/layout.rs of mavc, for an editor.
//
// - A newline ends a statement, except inside `( )` and `[ ]`. There it ends the statement only if the next line plainly
//   begins another one, so that a bracket just being typed costs one statement and not the rest of the file.
// - A unit is one run without blanks. It ends before `*` or `/` if no unit follows, and words that go on with a statement
//   are no units: in `weight 2 time 30 s` the word `time` begins a clause.

#include "tree_sitter/alloc.h"
#include "tree_sitter/parser.h"
#include <string.h>

// In the order of `externals` in grammar.js.
enum Token {
    NEWLINE, // ends a statement
    JOINT,   // a newline inside brackets
    UNIT,
    LEFT_PAREN,
    RIGHT_PAREN,
    LEFT_BRACKET,
    RIGHT_BRACKET,
    LEFT_BRACE,
    RIGHT_BRACE,
    SEMICOLON,
    ERROR_SENTINEL, // in no rule, so valid only while the parser looks for a way out of an error
};

typedef struct {
    uint8_t open_brackets;
} Scanner;

// `continuing_word` of the grammar. The words between the marks are written from the table of the language.
static const char *const CONTINUING_WORDS[] = {
    "rotors", "rotor", "lost", "reduced", "stuck", "to", "as", "in", "where",
    // words: clauses
    "arrive", "at", "corridor", "drag_coefficient", "max_speed", "max_thrust", "min_speed", "min_thrust", "motor",
    "pass", "rotor_inertia", "spin", "stop", "straight", "thrust_coefficient", "time_constant", "time",
    "torque_per_thrust", "until", "vertical", "weight", "within", "yaw_within", "yaw"
    // end of words
};

enum { LONGEST_WORD = 31 };

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }
static bool is_letter(int32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool is_name_char(int32_t c) { return is_letter(c) || is_digit(c) || c == '_'; }
static bool is_blank(int32_t c) { return c == ' ' || c == '\t' || c == '\r'; }

static void advance(TSLexer *lexer) { lexer->advance(lexer, false); }

static void pass_blanks(TSLexer *lexer) {
    while (is_blank(lexer->lookahead)) advance(lexer);
}

// Passes over a name; false if none stands here, or one that is no unit.
static bool unit_name(TSLexer *lexer) {
    if (!is_letter(lexer->lookahead)) return false;
    char word[LONGEST_WORD + 1] = {0};
    for (size_t length = 0; is_name_char(lexer->lookahead); length++) {
        if (length < LONGEST_WORD) word[length] = (char)lexer->lookahead;
        advance(lexer);
    }
    for (size_t i = 0; i < sizeof CONTINUING_WORDS / sizeof *CONTINUING_WORDS; i++) {
        if (strcmp(word, CONTINUING_WORDS[i]) == 0) return false;
    }
    return lexer->lookahead != '(';
}

// `m`, `m^2`, `s^-1`, `%`. The token ends behind it, or where it ended before if none stands here.
static bool unit_factor(TSLexer *lexer) {
    if (lexer->lookahead == '%') {
        advance(lexer);
    } else if (!unit_name(lexer)) {
        return false;
    }
    lexer->mark_end(lexer);
    if (lexer->lookahead != '^') return true;
    advance(lexer);
    if (lexer->lookahead == '-') advance(lexer);
    if (!is_digit(lexer->lookahead)) return true;
    while (is_digit(lexer->lookahead)) advance(lexer);
    lexer->mark_end(lexer);
    return true;
}

static bool unit(TSLexer *lexer) {
    if (lexer->lookahead == '1') {
        advance(lexer);
        if (lexer->lookahead != '/') return false;
        advance(lexer);
    }
    if (!unit_factor(lexer)) return false;
    do {
        if (lexer->lookahead != '*' && lexer->lookahead != '/') break;
        advance(lexer);
    } while (unit_factor(lexer));
    lexer->result_symbol = UNIT;
    return true;
}

// Whether the line that begins here cannot go on inside a bracket: `name =`, `name <=`, `name value` and `}` never stand
// in an expression.
static bool statement_begins(TSLexer *lexer) {
    pass_blanks(lexer);
    bool named = is_name_char(lexer->lookahead) && !is_digit(lexer->lookahead);
    while (is_name_char(lexer->lookahead)) advance(lexer);
    pass_blanks(lexer);
    if (!named) return lexer->lookahead == '}';
    switch (lexer->lookahead) {
        case '=': case '<': case '>': case '"': case '[': case '{': return true;
        default: return is_name_char(lexer->lookahead);
    }
}

static bool newline(Scanner *scanner, TSLexer *lexer) {
    advance(lexer);
    lexer->mark_end(lexer);
    if (scanner->open_brackets > 0 && !statement_begins(lexer)) {
        lexer->result_symbol = JOINT;
    } else {
        scanner->open_brackets = 0;
        lexer->result_symbol = NEWLINE;
    }
    return true;
}

static bool mark(TSLexer *lexer, enum Token token) {
    advance(lexer);
    lexer->mark_end(lexer);
    lexer->result_symbol = token;
    return true;
}

static bool opening(Scanner *scanner, TSLexer *lexer, enum Token token) {
    if (scanner->open_brackets < UINT8_MAX) scanner->open_brackets++;
    return mark(lexer, token);
}

static bool closing(Scanner *scanner, TSLexer *lexer, enum Token token) {
    if (scanner->open_brackets > 0) scanner->open_brackets--;
    return mark(lexer, token);
}

// A mark before which every bracket should be closed.
static bool giving_up(Scanner *scanner, TSLexer *lexer, enum Token token) {
    scanner->open_brackets = 0;
    return mark(lexer, token);
}

bool tree_sitter_mav_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid_symbols) {
    Scanner *scanner = payload;
    while (is_blank(lexer->lookahead)) lexer->advance(lexer, true);
    switch (lexer->lookahead) {
        case '\n': return newline(scanner, lexer);
        case '(': return opening(scanner, lexer, LEFT_PAREN);
        case ')': return closing(scanner, lexer, RIGHT_PAREN);
        case '[': return opening(scanner, lexer, LEFT_BRACKET);
        case ']': return closing(scanner, lexer, RIGHT_BRACKET);
        case '{': return giving_up(scanner, lexer, LEFT_BRACE);
        case '}': return giving_up(scanner, lexer, RIGHT_BRACE);
        case ';': return giving_up(scanner, lexer, SEMICOLON);
        default: return valid_symbols[UNIT] && !valid_symbols[ERROR_SENTINEL] && unit(lexer);
    }
}

void *tree_sitter_mav_external_scanner_create(void) { return ts_calloc(1, sizeof(Scanner)); }

void tree_sitter_mav_external_scanner_destroy(void *payload) { ts_free(payload); }

unsigned tree_sitter_mav_external_scanner_serialize(void *payload, char *buffer) {
    buffer[0] = (char)((Scanner *)payload)->open_brackets;
    return 1;
}

void tree_sitter_mav_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    ((Scanner *)payload)->open_brackets = length == 1 ? (uint8_t)buffer[0] : 0;
}
