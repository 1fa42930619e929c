# Shorter names. Nothing here is needed: `.ci/run` is the one command that decides, here and in CI.

# List the recipes.
default:
    @{{ just_executable() }} --list

# Everything that CI runs.
ci:
    bash .ci/run

# The tests, without the long ones, or those with NAME in their name.
test NAME="":
    cargo test {{ if NAME == "" { "" } else { "--test it " + NAME } }}

# The long tests; `very` for the very long ones.
test-long WHICH="":
    cargo test --test it -- --ignored {{ if WHICH == "very" { "thorough" } else { "--skip thorough" } }}

# Accept what the stages print now, and show what changed.
snapshots:
    INSTA_UPDATE=always cargo test -- --include-ignored
    git diff --stat -- tests

# Lay out the code and the specs.
fmt:
    cargo fmt
    cargo run --quiet -- fmt specs examples src

# Look for mistakes without running anything.
lint:
    cargo fmt --check
    cargo clippy --all-targets -- -D warnings

# The Python package, without its long tests; needs what `just test` builds.
python:
    bash python/check.sh quick

# The documentation of the code, private items included.
docs:
    RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --document-private-items

# The documentation for readers as a site at http://127.0.0.1:8000.
site:
    bash docs/site/run serve

# Measure; see docs/performance.md.
bench *ARGS:
    cargo bench {{ ARGS }}

# Write docs/reproduction.md anew. Takes minutes.
reproduce:
    cargo bench --bench reproduce -- --write

# Build the package as a user would get it.
package:
    cargo package
