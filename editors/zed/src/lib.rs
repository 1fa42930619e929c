use zed_extension_api as zed;

struct Mav;

impl zed::Extension for Mav {
    fn new() -> Self {
        Mav
    }

    fn language_server_command(
        &mut self,
        _id: &zed::LanguageServerId,
        worktree: &zed::Worktree,
    ) -> zed::Result<zed::Command> {
        let command = worktree.which("mavc").ok_or("mavc is not on the PATH")?;
        Ok(zed::Command { command, args: vec!["lsp".into()], env: worktree.shell_env() })
    }
}

zed::register_extension!(Mav);
