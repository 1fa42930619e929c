//! What shells and `man` want to know of the command line; clap knows it.

use super::target::{Target, cannot_write, write};
use super::{Cli, FINE, Problem, files};
use crate::diagnostic::codes;
use clap::CommandFactory;
use clap::builder::PossibleValuesParser;
use clap_complete::Shell;
use clap_mangen::Man;
use std::path::Path;

/// `mavc completions`
pub fn completions(shell: Shell) -> Result<u8, Problem> {
    // Which code is none `explain` says better than clap: here alone is the list part of the command line.
    let codes: PossibleValuesParser = codes::all().iter().map(|page| page.code).into();
    let mut command = Cli::command().mut_subcommand("explain", |c| c.mut_arg("code", |code| code.value_parser(codes)));
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, "mavc", &mut script);
    let script = String::from_utf8_lossy(&script);
    match shell {
        Shell::Bash => files::print(&choosy(&script))?,
        Shell::Fish => files::print(&(script.into_owned() + &codes_for_fish()))?,
        _ => files::print(&script)?,
    }
    Ok(FINE)
}

/// The script of clap for bash offers every option at every place, and then no file: another function picks.
fn choosy(script: &str) -> String {
    let (functions, registration) = script.split_once("\nif [[ \"${BASH_VERSINFO").unwrap_or((script, ""));
    let registration = registration.replace("complete -F _mavc ", "complete -F _mavc_words ");
    format!("{functions}\n{}if [[ \"${{BASH_VERSINFO{registration}", include_str!("shell/words.bash"))
}

/// The script of clap for fish offers no values of arguments without a name.
fn codes_for_fish() -> String {
    let codes: Vec<&str> = codes::all().iter().map(|page| page.code).collect();
    format!("complete -c mavc -n \"__fish_mavc_using_subcommand explain\" -f -a \"{}\"\n", codes.join(" "))
}

/// `mavc man`: the page of the whole on standard output, or that and one for each command in a folder, which is made where
/// it is missing.
pub fn man(folder: Option<&Path>) -> Result<u8, Problem> {
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    let Some(folder) = folder else {
        files::print(&page(&command)?.1)?;
        return Ok(FINE);
    };
    let commands = std::iter::once(&command).chain(command.get_subcommands());
    let pages = commands.map(page).collect::<Result<Vec<_>, _>>()?;
    std::fs::create_dir_all(folder).map_err(|e| cannot_write(folder, &e))?;
    let targets = pages.iter().map(|(name, _)| Target::within(folder, name)).collect::<Result<Vec<_>, _>>()?;
    write(&targets.iter().zip(&pages).map(|(target, (_, text))| (target, text.as_str())).collect::<Vec<_>>())?;
    Ok(FINE)
}

/// File name and text.
fn page(command: &clap::Command) -> Result<(String, String), Problem> {
    let man = Man::new(command.clone());
    let mut text = Vec::new();
    man.render(&mut text).map_err(|e| format!("cannot write a manual page: {}", files::reason(&e)))?;
    // The one thing said behind the options is what the exit codes mean.
    let text = String::from_utf8_lossy(&text).replace("\n.SH EXTRA\n", "\n.SH \"EXIT STATUS\"\n");
    Ok((man.get_filename(), text))
}
