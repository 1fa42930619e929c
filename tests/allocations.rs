//! A flight allocates no memory once it has begun. A binary of its own, because it counts every allocation.

#[path = "it/vehicles.rs"]
#[allow(dead_code)]
mod vehicles;

use mavc::flight::reference::{Course, Reference, Stop};
use mavc::flight::{Sortie, fly};
use mavc::model::{Allocation, Controller, Strike};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Of this thread alone: the test harness has others.
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let _ = COUNT.try_with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

#[test]
fn a_longer_flight_allocates_no_more() {
    for (controller, allocation) in
        [(Controller::Geometric, Allocation::Bounded), (Controller::Pd, Allocation::PseudoInverse)]
    {
        let mut model = vehicles::octocopter("PPNNPPNN");
        model.modes = vec![vehicles::lost(&model, &[3])];
        model.simulation.controller = controller;
        model.vehicle.allocation = allocation;
        model.simulation.gusts = 0.5;
        model.simulation.drag = [0.2; 3];
        let strikes = [Strike { mode: 0, at: 0.5, until: None, span: Default::default(), at_span: Default::default() }];
        let place = Reference { position: nalgebra::Vector3::new(0.0, 0.0, 10.0), ..Reference::default() };
        let count = |duration: f64| {
            let before = COUNT.get();
            let flight = fly(
                &Sortie {
                    model: &model,
                    vehicle: std::borrow::Cow::Borrowed(&model.vehicle),
                    simulation: &model.simulation,
                    course: Course::Stop(Box::new(Stop::from(&place, 0.0, false, 0.0))),
                    mission: None,
                    strikes: &strikes,
                    seed: 1,
                    duration,
                    airspeed: 1.0,
                    goes_on: false,
                    ways_out: None,
                },
                None,
            );
            assert!(!flight.outcome.is_lost() && flight.found[0].isolated_after.is_some(), "{flight:?}");
            (COUNT.get() - before, flight.steps)
        };
        let (short, long) = (count(2.0), count(6.0));
        assert!(long.1 > 2 * short.1);
        assert_eq!(long.0, short.0, "{controller:?}");
    }
}
