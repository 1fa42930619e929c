'use strict';

const assert = require('node:assert/strict');
const test = require('node:test');
const { indentationRules, onEnterRules } = require('../language-configuration.json');

test('the line after an open bracket is indented', () => {
  const indents = (line) => new RegExp(indentationRules.increaseIndentPattern).test(line);
  for (const line of ['vehicle octo {', '    inertia = [', 'faults {   // what may break', 'x = "}" + (', 'rotors [1, 6] {']) {
    assert.ok(indents(line), line);
  }
  for (const line of ['x = [1, 2] m', 'rotor { max_thrust = 3 N }', '// vehicle {', 'layout = "{"', '}', '']) {
    assert.ok(!indents(line), line);
  }
});

test('a bracket that closes goes back', () => {
  const goesBack = (line) => new RegExp(indentationRules.decreaseIndentPattern).test(line);
  assert.ok(goesBack('    ] kg*m^2') && goesBack('}') && !goesBack('x = [1]'));
});

test('a description goes on in the next line, a comment does not', () => {
  const goesOn = (line) => onEnterRules.some((rule) => new RegExp(rule.beforeText.pattern).test(line));
  assert.ok(goesOn('    /// The lamp') && !goesOn('// note') && !goesOn('//// rule') && !goesOn('x = 1 /// behind'));
});
