//! The outcome of planning one spec is refused together with another spec.

use mavc::observer::Silent;
use mavc::{NoFlight, OtherSpec, Spec, Task, Uncertified, Unexplained};

/// The template's mission for the hover model, with an override.
fn spec(field: &str) -> Spec {
    let compiler = mavc::Compiler::new().set("plan.model = hover").set("plan.samples = 60").set(field);
    compiler.without_flights().text("roof.mav", mavc::TEMPLATE.as_bytes()).into_result().unwrap()
}

#[test]
fn a_plan_of_another_spec_is_refused() {
    let planned = spec("plan.time = 20 s");
    let planning = mavc::plan(&planned).unwrap();
    assert!(planning.plan().is_some());
    let heavier = planned.set("vehicle.mass = 2.5 kg").unwrap();
    let comment = mavc::TEMPLATE.to_string() + "\n// Another text.\n";
    let rewritten = mavc::compile(&comment).into_result().unwrap();
    for other in [&heavier, &rewritten] {
        assert_eq!(mavc::certify(other, &planning).unwrap_err(), Uncertified::OtherSpec(OtherSpec));
        assert_eq!(mavc::fly(other, &planning).unwrap_err(), NoFlight::OtherSpec(OtherSpec));
        assert_eq!(mavc::explain(other, &planning).unwrap_err(), Unexplained::OtherSpec(OtherSpec));
        let task = Task::new(other).unwrap();
        assert_eq!(task.explain(&planning, &Silent).unwrap_err(), OtherSpec);
        assert_eq!(planning.between(&task, &Silent).unwrap_err(), OtherSpec);
    }
    assert_eq!(OtherSpec.to_string(), "this plan was made for another spec: plan this spec again");
}

#[test]
fn a_plan_of_the_same_spec_compiled_again_is_accepted() {
    let planning = mavc::plan(&spec("plan.time = 20 s")).unwrap();
    let again = spec("plan.time = 20 s");
    assert!(mavc::certify(&again, &planning).is_ok());
    assert!(mavc::fly(&again, &planning).is_ok());
    assert_eq!(mavc::explain(&again, &planning).unwrap(), Default::default());
    assert!(planning.between(&Task::new(&again).unwrap(), &Silent).unwrap().is_some());
}
