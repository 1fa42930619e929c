//! The page's skeleton: head, sections in order, the time slider, and the data for the script.

use super::content::Content;
use super::embed;
use super::prose::{prose, unbroken};
use super::summary::{Figure, Found};
use crate::model::{Model, Problem};
use crate::number::part_of_all;
use crate::planner::studies::Comparison;
use crate::report::terminal::vehicle_line;
use crate::report::without_yaw;
use crate::source::visible;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A section of the page, which the contents link to.
pub struct Section {
    pub id: &'static str,
    pub name: &'static str,
    pub body: Markup,
}

impl Section {
    pub fn new(id: &'static str, name: &'static str, body: Markup) -> Self {
        Section { id, name, body }
    }
}

/// What a page is about.
pub struct About<'a> {
    /// Its heading, such as `Mission roof`.
    pub heading: String,
    pub model: &'a Model,
    /// What the answer is for, in words; empty if there is nothing to say.
    pub setting: String,
}

impl<'a> About<'a> {
    /// A mission, and how it was planned.
    pub fn of_mission(problem: Problem<'a>, comparison: Option<&Comparison>) -> Self {
        let heading = format!("Mission {}", problem.mission().name);
        About { heading, model: problem.model(), setting: setting(problem.model(), comparison) }
    }
}

/// Everything that goes into a page.
pub struct Document<'a> {
    pub about: About<'a>,
    pub found: Found,
    /// A drawing below the headline.
    pub drawing: Option<Markup>,
    /// What is beside the headline; `None` if nothing is.
    pub picture: Option<Markup>,
    pub sections: Vec<Section>,
    pub content: Content,
}

impl Document<'_> {
    /// The page as HTML.
    pub fn render(&self) -> String {
        let moves = !self.content.runs.is_empty();
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                (head(&self.title()))
                body {
                    a.skip href="#main" { "Skip to the report" }
                    header.top {
                        div {
                            h1 { (self.about.heading) }
                            p.subject { (vehicle_line(self.about.model)) }
                            @if !self.about.setting.is_empty() { p.subject.setting { (self.about.setting) } }
                        }
                        button #theme type="button" hidden { "Dark theme" }
                    }
                    nav.contents aria-label="Contents" {
                        ul {
                            li { a href="#found" { "Result" } }
                            @for section in &self.sections { li { a href={ "#" (section.id) } { (section.name) } } }
                        }
                    }
                    @if moves || !self.content.sets.is_empty() {
                        noscript {
                            p.warning {
                                "This browser does not run scripts, so the path, the sets and the charts are not \
                                 drawn. Text, tables and the spec follow below."
                            }
                        }
                    }
                    main #main {
                        section #found { (self.first_screen()) }
                        @for section in &self.sections { section id=(section.id) { (section.body) } }
                    }
                    @if moves { (player()) }
                    footer {
                        p {
                            "Written by mavc " (env!("CARGO_PKG_VERSION")) ". Lengths in m, times in s, SI units \
                             except angles in degrees. Charts by uPlot and three.js (MIT); the source of this page \
                             contains their licences."
                        }
                    }
                    script #content type="application/json" { (PreEscaped(embed::json(&self.content))) }
                    script { (PreEscaped(embed::SCRIPT)) }
                }
            }
        };
        // Script and style, whose hashes must not change, contain no such character.
        visible::text(&page.into_string()).into_owned()
    }

    /// The answer, and beside it the picture.
    fn first_screen(&self) -> Markup {
        let doc = self.about.model.mission.as_ref().and_then(|mission| mission.doc.as_ref());
        let doc = html! { @if let Some(doc) = doc { p.doc { (doc) } } };
        let (answer, rest) = found(&self.found);
        html! {
            @match &self.picture {
                Some(picture) => {
                    div.first {
                        div.answer {
                            (answer)
                            @if let Some(drawing) = &self.drawing { (drawing) }
                            (doc)
                        }
                        div.picture { (picture) }
                    }
                    (rest)
                }
                None => { (answer) (rest) (doc) }
            }
        }
    }

    /// `roof: PLAN FOUND, 20 s; planner RSP (risk-sensitive)`: what a browser's tab shows.
    fn title(&self) -> String {
        let of = self.about.heading.split_once(' ').map_or("", |(_, name)| name);
        let headline = self.found.headline.replace('`', "");
        // The headline of an analysis begins with the vehicle.
        if headline.starts_with(&format!("{of}:")) { headline } else { format!("{of}: {headline}") }
    }
}

/// How a mission was planned: the modes planned against, model, reserve and samples.
fn setting(model: &Model, comparison: Option<&Comparison>) -> String {
    let plan = &model.plan;
    let declared = || plan.against.iter().map(|&i| model.modes[i].name.clone()).collect();
    let modes: Vec<String> = comparison.map_or_else(declared, |c| c.modes.clone());
    let against = match modes.len() {
        0 => "no fault modes, ".to_string(),
        n if n > 12 => format!("against {n} fault modes, "),
        _ => format!("against {}, ", modes.join(", ")),
    };
    let mut setting = format!(
        "{against}{} model, reserve {} % of each set, {} samples",
        plan.model.name(),
        part_of_all(plan.reserve),
        plan.samples
    );
    for sentence in comparison.map_or_else(Vec::new, |comparison| without_yaw::head(comparison, None)) {
        setting.push_str(&format!(". {sentence}"));
    }
    setting
}

/// The head of a page.
pub fn head(title: &str) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta http-equiv="Content-Security-Policy" content=(embed::policy(false));
            meta name="color-scheme" content="light dark";
            meta name="generator" content={ "mavc " (env!("CARGO_PKG_VERSION")) };
            title { (title) }
            style { (PreEscaped(embed::STYLE)) }
        }
    }
}

/// Figures beside the picture; the others follow below it, except those that are bad.
const FIRST_FIGURES: usize = 4;

/// The headline with what is covered, the first figures and the warnings; and the other figures.
fn found(found: &Found) -> (Markup, Markup) {
    let (first, rest): (Vec<_>, Vec<_>) =
        found.figures.iter().enumerate().partition(|(i, figure)| *i < FIRST_FIGURES || figure.is_bad);
    let answer = html! {
        h2.headline { (prose(&found.headline)) }
        @for part in &found.coverage { p.coverage.bad[part.covers.is_bad()] { (prose(&part.sentence)) } }
        @if let Some(price) = &found.price { p.coverage { (prose(price)) } }
        (figures(first.into_iter().map(|(_, figure)| figure).collect()))
        @for warning in &found.warnings { p.warning { (prose(warning)) } }
    };
    (answer, figures(rest.into_iter().map(|(_, figure)| figure).collect()))
}

fn figures(figures: Vec<&Figure>) -> Markup {
    html! {
        @if !figures.is_empty() {
            dl.figures {
                @for figure in figures {
                    div {
                        dt { (figure.name) }
                        dd.value.bad[figure.is_bad] { (unbroken(&figure.value)) }
                        dd.note { (unbroken(&figure.note)) }
                    }
                }
            }
        }
    }
}

/// What the script draws on the first screen: the flight in space, and below it the margins over time.
pub fn picture(has_modes: bool) -> Markup {
    html! {
        div #flight {
            div.tools {
                h2 #space-headline { "The path in space" }
                label { "Colour " select #colour { } }
                div.buttons role="group" aria-label="View" {
                    button type="button" data-view="free" { "Oblique" }
                    button type="button" data-view="top" { "Top" }
                    button type="button" data-view="front" { "Front" }
                    button type="button" data-view="side" { "Side" }
                }
            }
            div #space .canvas tabindex="0" role="application" aria-label="Path in space; arrow keys turn it, plus \
                and minus zoom" { }
            div #space-legend .legend { }
            p #space-readout .readout { }
        }
        @if has_modes {
            div #heat {
                h2 { "If a fault strikes: when would it meet a violation of its mode's set?" }
                p #strips-headline .unit { }
                div #strips-legend .legend { }
                div #strips { }
            }
        }
        details #space-about { summary { "How to read the picture" } p #space-note .note { } }
    }
}

/// The section of the curves over time, which the script fills.
pub fn motion() -> Section {
    let charts = html! {
        h2 { "The trajectory and its limits over time" }
        p.note {
            "Dashed lines are limits; numbers at the right are those of the instant shown. Shaded bands in the charts \
             of thrust and torques: the range of that component in the set of the selected mode, with the other three \
             components fixed at their values at that instant."
        }
        div #charts { }
    };
    Section::new("motion", "Trajectory", charts)
}

/// The section of admissible sets, which the script fills.
pub fn sets() -> Section {
    let body = html! {
        h2 #sets-headline { "The admissible set of each mode" }
        p.note #sets-note { }
        div.tools {
            label { "Mode " select #set { } }
            label { "Section " select #plane {
                option value="wrench" { "through the wrench shown" }
                option value="hover" { "through hover (T = m g)" }
            } }
        }
        div #sections .sections { }
        div.pair {
        figure #solid {
            figcaption { h3 { "The set without torque about z" } }
            div .canvas tabindex="0" role="application" aria-label="The admissible set as a body; arrow keys turn it, \
                plus and minus zoom" { }
            p.note.none hidden { "Hover does not lie inside this mode's set, so no body is drawn." }
        }
        div #room .room tabindex="0" role="region" aria-label="Range of each component" { }
        }
        h3 { "All modes: torques about x and y" }
        div #multiples .multiples { }
    };
    Section::new("sets", "Sets", body)
}

/// The controls for the instant that all charts show.
fn player() -> Markup {
    html! {
        div #player role="region" aria-label="Instant shown" hidden {
            button #play type="button" aria-label="Play" { "Play" }
            input #time type="range" min="0" max="1" step="any" value="0" aria-label="Time in the flight";
            output #clock for="time" { "0 s" }
            label #run-label { "Shown " select #run { } }
        }
    }
}
