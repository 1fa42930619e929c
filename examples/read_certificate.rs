//! Plans, makes a certificate, reads it back and verifies it: `cargo run --release --example read_certificate`.

use mavc::{Certificate, Compiler};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let spec = Compiler::new().file("specs/paper/case1.mav")?.into_result()?;
    let json = serde_json::to_vec(&mavc::certify(&spec, &mavc::plan(&spec)?)?)?;

    let certificate: Certificate = serde_json::from_slice(&json)?;
    println!("schema {}, for the spec {}...", certificate.schema, &certificate.spec_sha256[..12]);
    let verdict = mavc::verify(&json, &spec)?;
    println!("{}", verdict.headline);
    for shown in &verdict.shown {
        println!("  shown: {}", shown.statement);
    }
    for weaker in &verdict.weaker {
        println!("  weaker than the spec requires: {weaker}");
    }
    Ok(())
}
