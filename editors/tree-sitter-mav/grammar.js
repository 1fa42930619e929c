/**
 * @file The mav language, for highlighting, folding and moving about in editors.
 *
 * What counts is ../../grammar/mav.pest; rules here have its names. One thing is stricter: a known block has the head
 * that it must have (`vehicle NAME`, `plan`), where the compiler first reads any words before a `{` and then tells
 * what is wrong with them. As there, every statement may stand in every block, so that one out of place costs nothing.
 *
 * src/scanner.c settles what needs a view beyond one token: which newlines end a statement, and where a unit ends.
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

// From loosest to tightest.
const PRECEDENCE = { range: 1, interval: 2, sum: 3, product: 4, sign: 5, power: 6 };

// The words between marks like the next two are written from the table of the language (CONTRIBUTING.md).

// Words that begin a statement. They are also names of fields: `vehicle = octo`, `rotors = lagging`.
const STATEMENT_WORDS = [
  // words: statements
  'use', 'let', 'require', 'vehicle', 'faults', 'mission', 'plan', 'simulate', 'campaign', 'limits', 'mode', 'every',
  'curve', 'rotor', 'rotors', 'start', 'end', 'waypoint', 'waypoints', 'hold', 'fault', 'keep_in', 'keep_out',
  'battery', 'air', 'after_fault_limits', 'keep_off', 'landing_site', 'recovery', 'parts', 'part'
  // end of words
];

const CLAUSE_WORDS = [
  // words: clauses with a value
  'at', 'yaw_within', 'yaw', 'within', 'weight', 'time_constant', 'time', 'spin', 'min_speed', 'max_speed',
  'min_thrust', 'max_thrust', 'thrust_coefficient', 'drag_coefficient', 'torque_per_thrust', 'rotor_inertia', 'motor',
  'until', 'corridor'
  // end of words
];

// Clauses of a waypoint without a value.
const BARE_WORDS = [
  // words: clauses without a value
  'straight', 'vertical', 'stop', 'pass'
  // end of words
];

// Clauses of a waypoint with `from` before the value.
const FROM_WORDS = ['arrive'];

const commaSeparated = (rule) => seq(rule, repeat(seq(',', rule)));

module.exports = grammar({
  name: 'mav',

  word: ($) => $.name,

  // The scanner counts brackets, so every mark that opens, closes or gives up brackets is its own.
  externals: ($) => [$._newline, $._joint, $.unit, '(', ')', '[', ']', '{', '}', ';', $._error_sentinel],

  extras: ($) => [/[ \t\r]/, $._joint, $.comment, $.doc_comment],

  supertypes: ($) => [$.expression],

  rules: {
    source_file: ($) => $._statements,

    body: ($) => seq('{', optional($._statements), '}'),

    // A block may be followed by anything, any other statement by the end of its line, `;`, or the end around it.
    _statements: ($) =>
      choice(
        seq(repeat1(choice($._separator, $._block, seq($._simple, $._separator))), optional($._simple)),
        $._simple,
      ),
    _separator: ($) => choice($._newline, ';'),

    _simple: ($) =>
      choice(
        $.field, $.limit, $.requirement, $.import, $.binding, $.moving, $.survey, $.hold, alias($._every_head, $.every),
        alias($._start_head, $.start), alias($._waypoint_head, $.waypoint), $.fault, $.rotor, $.strike,
      ),

    _block: ($) =>
      choice(
        $.vehicle, $.faults, $.mission, $.plan, $.simulate, $.campaign, $.limits, $.volume, $.mode, $.curve,
        $.rotor_block, $.rotors_block, $.battery, $.parts, $.part, $.air, $.landing_site, $.after_fault_limits,
        $.recovery, alias($._every_block, $.every), alias($._start_block, $.start),
        alias($._waypoint_block, $.waypoint), alias($._requirement_block, $.requirement),
      ),

    // ---- blocks

    vehicle: ($) => seq('vehicle', field('name', $.name), field('body', $.body)),
    faults: ($) => seq('faults', field('body', $.body)),
    mission: ($) => seq('mission', field('name', $.name), field('body', $.body)),
    plan: ($) => seq('plan', field('body', $.body)),
    simulate: ($) => seq('simulate', field('body', $.body)),
    campaign: ($) => seq('campaign', field('body', $.body)),
    limits: ($) => seq('limits', field('body', $.body)),
    air: ($) => seq('air', field('body', $.body)),
    landing_site: ($) => seq('landing_site', field('name', $.name), field('body', $.body)),
    after_fault_limits: ($) => seq('after_fault_limits', field('body', $.body)),
    recovery: ($) => seq('recovery', field('body', $.body)),
    volume: ($) => seq(choice('keep_in', 'keep_out', 'keep_off'), field('name', $.name), field('body', $.body)),
    mode: ($) => seq('mode', field('name', $.name), field('title', optional($.text)), field('body', $.body)),
    rotor_block: ($) => seq('rotor', field('body', $.body)),
    rotors_block: ($) => seq('rotors', field('body', $.body)),
    battery: ($) => seq('battery', field('body', $.body)),
    parts: ($) => seq('parts', field('body', $.body)),
    part: ($) => seq('part', field('name', $.name), field('body', $.body)),

    curve: ($) =>
      seq(
        'curve', field('parameter', $.name), 'in', field('range', $.expression), repeat(seq(',', $.field)),
        field('body', $.body),
      ),

    _every_block: ($) => seq($._every_head, field('body', $.body)),
    _every_head: ($) =>
      seq(
        'every', field('count', $.expression), choice('rotor', 'rotors'), field('effect', $._effect), 'as',
        field('name', $.name),
      ),

    // ---- statements

    field: ($) => seq(field('name', $._field_name), '=', field('value', choice($.filter, $.expression))),
    filter: ($) =>
      seq('where', field('name', $.name), field('relation', $._relation), field('value', $.expression)),
    _relation: (_) => choice('<=', '>=', '<', '>', '='),

    limit: ($) =>
      seq(
        field('name', $._field_name), field('relation', choice('<=', '>=', '<', '>', 'in')),
        field('value', $.expression),
      ),

    requirement: ($) => seq('require', field('name', $.name), '<=', field('value', $.expression)),
    _requirement_block: ($) => seq('require', field('name', $.name), field('body', $.body)),
    import: ($) => seq('use', field('path', $.text)),
    binding: ($) => seq('let', field('name', $.name), '=', field('value', $.expression)),

    fault: ($) => seq(choice('rotors', 'rotor'), field('rotors', $.expression), field('effect', $._effect)),
    _effect: ($) => choice($.lost, $.reduced, $.stuck),
    lost: (_) => 'lost',
    reduced: ($) => seq('reduced', 'to', $.expression),
    stuck: ($) => seq('stuck', 'at', $.expression),

    rotor: ($) => seq('rotor', repeat1($.clause)),
    _start_head: ($) => seq('start', repeat1($._waypoint_clause)),
    _start_block: ($) => seq($._start_head, field('body', $.body)),
    _waypoint_head: ($) => seq('waypoint', field('name', optional($.name)), repeat1($._waypoint_clause)),
    _waypoint_block: ($) => seq($._waypoint_head, field('body', $.body)),
    strike: ($) => seq('fault', field('mode', $.name), repeat1($.clause)),
    moving: (_) => seq(choice('start', 'end'), 'moving'),
    hold: ($) => seq('hold', field('time', $.expression)),
    survey: ($) => seq('waypoints', 'from', field('path', $.text)),

    clause: ($) =>
      seq(
        field('name', alias(choice(...CLAUSE_WORDS), $.clause_word)),
        field('value', $.expression),
      ),

    _waypoint_clause: ($) => choice($.clause, alias($._bare, $.clause), alias($._arrival, $.clause), alias($._heading, $.clause)),
    _bare: ($) => field('name', alias(choice(...BARE_WORDS), $.clause_word)),
    _arrival: ($) => seq(field('name', alias(FROM_WORDS[0], $.clause_word)), 'from', field('value', $.expression)),

    _heading: ($) =>
      seq(
        field('name', alias('yaw', $.clause_word)),
        choice(seq('towards', field('value', $.expression)), seq('along', 'path'), 'free'),
      ),

    _field_name: ($) => choice($.name, alias(choice(...STATEMENT_WORDS), $.name)),

    // ---- expressions

    expression: ($) =>
      choice($.call, $.quantity, $.reference, $.text, $.parenthesized, $.list, $.binary, $.negation, $.unknown),

    binary: ($) =>
      choice(
        ...[
          [prec.left, '..', PRECEDENCE.range],
          [prec.left, '+-', PRECEDENCE.interval],
          [prec.left, '+', PRECEDENCE.sum],
          [prec.left, '-', PRECEDENCE.sum],
          [prec.left, '*', PRECEDENCE.product],
          [prec.left, '/', PRECEDENCE.product],
          [prec.right, '^', PRECEDENCE.power],
        ].map(([grouping, operator, precedence]) =>
          // @ts-ignore
          grouping(
            precedence,
            seq(field('left', $.expression), field('operator', operator), field('right', $.expression)),
          ),
        ),
      ),
    negation: ($) => prec(PRECEDENCE.sign, seq('-', $.expression)),

    quantity: ($) => seq($.number, optional($.unit)),
    call: ($) =>
      seq(
        field('function', $.name), '(', field('arguments', optional(commaSeparated($.expression))), ')',
        optional($.unit),
      ),
    parenthesized: ($) => seq('(', $.expression, ')', optional($.unit)),
    list: ($) => seq('[', optional(seq(commaSeparated($.expression), optional(','))), ']', optional($.unit)),
    reference: ($) => $.name,

    // A figure that is to be filled in.
    unknown: () => '?',

    // ---- tokens

    number: (_) => /[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?/,
    name: (_) => /[A-Za-z_][A-Za-z0-9_]*/,
    text: (_) => /"[^"\n]*"/,

    // Three slashes, no fourth: this text belongs to the statement below.
    doc_comment: (_) => token(choice('///', /\/\/\/[^\/\r\n][^\r\n]*/)),
    comment: (_) => token(choice('//', /\/\/[^\/\r\n][^\r\n]*/, /\/\/\/\/[^\r\n]*/)),
  },
});
