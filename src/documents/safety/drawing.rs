//! The argument as a drawing: goals as rectangles, the strategy as a parallelogram, solutions as circles, contexts and
//! assumptions as rounded boxes, a diamond below what is undeveloped.

use super::argument::{Argument, Kind, Node};
use super::{Case, escaped};
use std::fmt::Write;

/// Sizes in units of the drawing; letters are about 7 wide.
const WIDTH: usize = 1180;
const LINE: usize = 17;
const PAD: usize = 10;
/// Left edges of goals, of what supports the strategy, of the right column, and their widths.
const ROOT: usize = 20;
const INDENT: usize = 70;
const GOAL: usize = 500;
const RIGHT: usize = 640;
const ASIDE: usize = 520;
const RADIUS: usize = 24;
/// Between boxes.
const GAP: usize = 18;
/// Letters of a line in a box of the width of goals and of the right column; beside a circle.
const LETTERS: usize = 64;
const LETTERS_ASIDE: usize = 62;
const LETTERS_OF_SOLUTION: usize = 58;

/// The drawing of an argument.
pub fn svg(case: &Case, argument: &Argument) -> String {
    let mut drawing = Drawing { body: String::new() };
    let mut y = GAP;
    let root = argument.node("G1");
    let strategy = argument.node("S1");
    let mut below = y;
    if let Some(root) = root {
        let height = drawing.boxed(root, ROOT, y, GOAL, LETTERS);
        let beside = drawing.aside(argument, &root.in_context_of, y, height);
        below = y + height.max(beside);
        if let Some(strategy) = strategy {
            let from = y + height;
            y = below + GAP;
            drawing.arrow([ROOT + 20, from], [ROOT + 20, y], false);
            let height = drawing.boxed(strategy, ROOT, y, GOAL, LETTERS);
            below = y + height;
        }
    }
    let trunk = below;
    y = below + GAP;
    let goals = strategy.into_iter().flat_map(|strategy| &strategy.supported_by);
    for goal in goals.filter_map(|id| argument.node(id)) {
        let height = drawing.boxed(goal, INDENT, y, GOAL, LETTERS);
        let middle = y + height / 2;
        drawing.corner([ROOT + 20, trunk], [INDENT, middle]);
        let mut beside = 0;
        for support in goal.supported_by.iter().filter_map(|id| argument.node(id)) {
            beside += match support.kind {
                Kind::Goal => drawing.goal_beside(support, y + beside, INDENT + GOAL, middle),
                _ => drawing.solution(support, y + beside, INDENT + GOAL, middle),
            };
        }
        beside += drawing.aside(argument, &goal.in_context_of, y + beside, height);
        y += height.max(beside) + if goal.undeveloped { 2 * GAP } else { GAP };
    }
    let title = format!("Argument for {}, spec {}", case.problem.mission().name, case.spec_sha256);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {y}\" width=\"{WIDTH}\" height=\"{y}\" \
         font-family=\"sans-serif\" font-size=\"13\">\n<title>{}</title>\n<defs><marker id=\"solid\" refX=\"9\" \
         refY=\"5\" markerWidth=\"10\" markerHeight=\"10\" orient=\"auto\"><path d=\"M0 0 L10 5 L0 10 z\"/></marker>\
         <marker id=\"hollow\" refX=\"9\" refY=\"5\" markerWidth=\"11\" markerHeight=\"11\" orient=\"auto\"><path \
         d=\"M0.5 0.5 L10 5 L0.5 9.5 z\" fill=\"white\" stroke=\"black\"/></marker></defs>\n<rect width=\"100%\" \
         height=\"100%\" fill=\"white\"/>\n{}</svg>\n",
        escaped(&title),
        drawing.body
    )
}

struct Drawing {
    body: String,
}

impl Drawing {
    /// Draws a node with its text, and returns its height.
    fn boxed(&mut self, node: &Node, x: usize, y: usize, width: usize, letters: usize) -> usize {
        let lines = wrapped(&format!("{}: {}", node.id, node.text), letters);
        let height = lines.len() * LINE + 2 * PAD;
        let style = "fill=\"white\" stroke=\"black\"";
        let right = x + width;
        let bottom = y + height;
        let _ = match node.kind {
            Kind::Strategy => {
                writeln!(self.body, "<path d=\"M{} {y} H{right} L{} {bottom} H{x} z\" {style}/>", x + PAD, right - PAD)
            }
            Kind::Context | Kind::Assumption => writeln!(
                self.body,
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"{}\" {style}/>",
                if node.kind == Kind::Context { 8 } else { height / 2 }
            ),
            Kind::Goal | Kind::Solution => {
                writeln!(self.body, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" {style}/>")
            }
        };
        if node.kind == Kind::Assumption {
            let _ = writeln!(self.body, "<text x=\"{right}\" y=\"{}\">A</text>", bottom + 4);
        }
        self.text(&lines, x + 2 * PAD, y + PAD);
        if node.undeveloped {
            let middle = x + width / 2;
            let _ = writeln!(
                self.body,
                "<path d=\"M{middle} {bottom} l9 9 l-9 9 l-9 -9 z\" {style}><title>undeveloped</title></path>"
            );
        }
        height
    }

    /// Draws contexts and assumptions in the right column, and returns the height that they take.
    fn aside(&mut self, argument: &Argument, ids: &[String], y: usize, height: usize) -> usize {
        let mut taken = 0;
        for node in ids.iter().filter_map(|id| argument.node(id)) {
            let own = self.boxed(node, RIGHT, y + taken, ASIDE, LETTERS_ASIDE);
            let edge = if node.kind == Kind::Goal { INDENT } else { ROOT } + GOAL;
            self.arrow([edge, y + height / 2], [RIGHT, y + taken + own / 2], true);
            taken += own + GAP / 2;
        }
        taken
    }

    /// Draws a goal that supports another one in the right column, and returns the height that it takes.
    fn goal_beside(&mut self, node: &Node, y: usize, from: usize, middle: usize) -> usize {
        let height = self.boxed(node, RIGHT, y, ASIDE, LETTERS_ASIDE);
        self.arrow([from, middle], [RIGHT, y + height / 2], false);
        height + if node.undeveloped { 2 * GAP } else { GAP }
    }

    fn solution(&mut self, node: &Node, y: usize, from: usize, middle: usize) -> usize {
        let hash = node.file.as_ref().map(|(_, hash)| format!(" SHA-256 {hash}")).unwrap_or_default();
        let lines = wrapped(&format!("{}{hash}", node.text), LETTERS_OF_SOLUTION);
        let height = (lines.len() * LINE).max(2 * RADIUS) + GAP / 2;
        let centre = [RIGHT + RADIUS, y + RADIUS];
        self.arrow([from, middle], [RIGHT, centre[1]], false);
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{RADIUS}\" fill=\"white\" stroke=\"black\"/><text x=\"{}\" y=\"{}\" \
             text-anchor=\"middle\">{}</text>",
            centre[0],
            centre[1],
            centre[0],
            centre[1] + 5,
            node.id
        );
        self.text(&lines, RIGHT + 2 * RADIUS + PAD, y);
        height
    }

    fn text(&mut self, lines: &[String], x: usize, y: usize) {
        for (k, line) in lines.iter().enumerate() {
            let _ = writeln!(self.body, "<text x=\"{x}\" y=\"{}\">{}</text>", y + k * LINE + 13, escaped(line));
        }
    }

    /// An arrow to what supports (solid), or to a context (hollow).
    fn arrow(&mut self, from: [usize; 2], to: [usize; 2], hollow: bool) {
        let head = if hollow { "hollow" } else { "solid" };
        let _ = writeln!(
            self.body,
            "<path d=\"M{} {} L{} {}\" fill=\"none\" stroke=\"black\" marker-end=\"url(#{head})\"/>",
            from[0], from[1], to[0], to[1]
        );
    }

    /// An arrow down and then to the right.
    fn corner(&mut self, from: [usize; 2], to: [usize; 2]) {
        let _ = writeln!(
            self.body,
            "<path d=\"M{} {} V{} H{}\" fill=\"none\" stroke=\"black\" marker-end=\"url(#solid)\"/>",
            from[0], from[1], to[1], to[0]
        );
    }
}

/// Lines of at most so many letters; a longer word, such as a hash, is broken.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let mut rest: Vec<char> = word.chars().collect();
        while !rest.is_empty() {
            let line = lines.last_mut().expect("there is a first line");
            let space = usize::from(!line.is_empty());
            let used = line.chars().count() + space;
            if used + rest.len() <= letters {
                line.push_str(&" ".repeat(space));
                line.extend(rest.drain(..));
            } else if rest.len() > letters && used < letters {
                line.push_str(&" ".repeat(space));
                line.extend(rest.drain(..letters - used));
            } else {
                lines.push(String::new());
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn long_words_are_broken_and_none_is_lost() {
        let text = format!("one two {} three", "f".repeat(64));
        let lines = wrapped(&text, 20);
        assert!(lines.iter().all(|line| line.chars().count() <= 20 && !line.is_empty()), "{lines:?}");
        assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
    }
}
