//! Completions for shells and manual pages, which clap generates from the arguments.

use super::target::{Target, cannot_write, write};
use super::{Cli, CommandError, FINE, files};
use crate::diagnostic::codes;
use clap::CommandFactory;
use clap::builder::PossibleValuesParser;
use clap_complete::Shell;
use clap_mangen::Man;
use std::path::Path;

/// `mavc completions`
pub fn completions(shell: Shell) -> Result<u8, CommandError> {
    // The list of codes is part of the arguments here only: `explain` reports an unknown code better than clap.
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

/// clap's script for bash offers every option at every place and no files; the function in `words.bash` filters it.
fn choosy(script: &str) -> String {
    let (functions, registration) = script.split_once("\nif [[ \"${BASH_VERSINFO").unwrap_or((script, ""));
    let registration = registration.replace("complete -F _mavc ", "complete -F _mavc_words ");
    format!("{functions}\n{}if [[ \"${{BASH_VERSINFO{registration}", include_str!("shell/words.bash"))
}

/// clap's script for fish offers no values for positional arguments.
fn codes_for_fish() -> String {
    let codes: Vec<&str> = codes::all().iter().map(|page| page.code).collect();
    format!("complete -c mavc -n \"__fish_mavc_using_subcommand explain\" -f -a \"{}\"\n", codes.join(" "))
}

/// `mavc man`: prints the page of mavc, or writes it and a page for each command into a folder, which is created if
/// missing.
pub fn man(folder: Option<&Path>) -> Result<u8, CommandError> {
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
    write(&targets.iter().zip(&pages).map(|(target, (_, text))| (target, text.as_bytes())).collect::<Vec<_>>())?;
    Ok(FINE)
}

/// The file name and the text of a command's page.
fn page(command: &clap::Command) -> Result<(String, String), CommandError> {
    let man = Man::new(command.clone());
    let mut text = Vec::new();
    man.render(&mut text).map_err(|e| format!("cannot write a manual page: {}", files::reason(&e)))?;
    // The text after the options is about exit codes.
    let text = String::from_utf8_lossy(&text).replace("\n.SH EXTRA\n", "\n.SH \"EXIT STATUS\"\n");
    Ok((man.get_filename(), text))
}
