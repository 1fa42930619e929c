//! Ways that are closed off, against a search on a lattice.

use super::*;
use crate::model::VolumeSide;

/// The vehicle's size, the step of the lattice of the other search, and the width of the room, m.
const SIZE: f64 = 0.3;
const STEP: f64 = 0.4;
const ROOM: f64 = 10.0;

fn volume(index: u32, side: VolumeSide, body: Body) -> Volume {
    let span = Span { start: index, end: index + 1, ..Span::default() };
    Volume { name: index.to_string(), side, bodies: vec![body], clearance: 0.0, span }
}

fn waypoint(position: [f64; 3]) -> Waypoint {
    Waypoint {
        name: None,
        position,
        yaw: 0.0,
        within: 0.05,
        yaw_within: 0.1,
        weight: 0.0,
        time: None,
        hold: 0.0,
        stop: false,
        heading: crate::model::Heading::Given,
        span: Span::default(),
        time_span: None,
        hold_span: None,
    }
}

fn violation(limits: &[Limit], p: [f64; 3]) -> f64 {
    let of = |limit: &Limit| {
        let value = limit.value_at(p).unwrap();
        (limit.lower.unwrap_or(f64::NEG_INFINITY) - value).max(value - limit.upper.unwrap_or(f64::INFINITY))
    };
    limits.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether points of a lattice that are free with half a step to spare join two points: then the lines between them are
/// free.
fn is_joined(limits: &[Limit], [from, to]: [[f64; 3]; 2]) -> bool {
    let count = (ROOM / STEP) as usize + 1;
    let point = |at: usize| [at % count, at / count % count, at / count / count].map(|k| k as f64 * STEP);
    let nearest = |p: [f64; 3]| {
        let [x, y, z] = p.map(|c| (c / STEP).round() as usize);
        x + count * (y + count * z)
    };
    let free: Vec<bool> = (0..count.pow(3)).map(|at| violation(limits, point(at)) <= -0.5 * STEP).collect();
    let (start, goal) = (nearest(from), nearest(to));
    let mut seen = vec![false; free.len()];
    let mut queue = vec![start];
    seen[start] = true;
    while let Some(at) = queue.pop() {
        if at == goal {
            return true;
        }
        for by in [1, count, count * count] {
            for next in [at.checked_sub(by), Some(at + by)].into_iter().flatten() {
                let is_beside = next < free.len()
                    && (0..3).map(|i| (point(at)[i] - point(next)[i]).abs()).sum::<f64>() < 1.5 * STEP;
                if is_beside && free[next] && !seen[next] {
                    seen[next] = true;
                    queue.push(next);
                }
            }
        }
    }
    false
}

/// Walls across a room, with gaps of any width, and other bodies: what is called closed off cannot be reached on a
/// lattice.
#[test]
fn what_is_closed_off_cannot_be_reached() {
    let mut seed = 7_u64;
    let mut number = |low: f64, high: f64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * ((seed >> 33) as f64 / f64::from(1_u32 << 31))
    };
    let (mut closed, mut joined) = (0, 0);
    for _ in 0..40 {
        let prism = |x: [f64; 2], y: [f64; 2], bottom: f64, top: f64, turn: f64| {
            let (sin, cos) = turn.sin_cos();
            let (cx, cy) = (0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]));
            let corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
            let turned = |(x, y): (f64, f64)| {
                let (u, v) = (x - cx, y - cy);
                [cx + cos * u - sin * v, cy + sin * u + cos * v]
            };
            Body::Prism { corners: corners.map(turned).to_vec(), bottom, top }
        };
        let at = number(3.0, 7.0);
        let wall = number(0.1, 1.0);
        let end = number(7.5, 10.5);
        let turn = if number(0.0, 1.0) < 0.5 { 0.0 } else { number(-0.3, 0.3) };
        let mut volumes = vec![
            volume(0, VolumeSide::KeepIn, prism([0.0, ROOM], [0.0, ROOM], 0.0, ROOM, 0.0)),
            volume(1, VolumeSide::KeepOut, prism([at, at + wall], [-1.0, end], -1.0, number(8.0, 11.0), turn)),
        ];
        let radius = number(0.5, 2.0);
        volumes.push(volume(2, VolumeSide::KeepOut, Body::Ball { centre: [at, 9.5, number(0.0, 10.0)], radius }));
        let cylinder = Body::Cylinder { centre: [at, 9.8], radius: number(0.1, 1.0), bottom: -1.0, top: 12.0 };
        volumes.push(volume(3, VolumeSide::KeepOut, cylinder));
        volumes.push(volume(
            4,
            VolumeSide::KeepOut,
            Body::HalfSpace { normal: [0.0, 0.6, 0.8], offset: number(-2.0, 3.0) },
        ));
        let limits: Vec<Limit> = volumes.iter().flat_map(|v| v.limits(SIZE)).collect();
        let ends = [[1.0, 5.0, 5.0], [9.0, 5.0, 5.0]];
        if ends.iter().any(|p| violation(&limits, *p) > -STEP) {
            continue;
        }
        let found = closed_off(&limits, &volumes, &ends.map(waypoint));
        match is_joined(&limits, ends) {
            true => {
                joined += 1;
                assert_eq!(found, None, "{volumes:?}");
            }
            false => closed += usize::from(found.is_some()),
        }
        if let Some(found) = found {
            assert!(found.by.iter().any(|&i| limits[i].span.start == 1), "{volumes:?} {found:?}");
        }
    }
    assert!(closed >= 5 && joined >= 10, "{closed} closed off, {joined} joined");
}

/// A wall that leaves no gap is found with what it needs, and a gap in it as wide as the vehicle is a way.
#[test]
fn a_wall_across_a_room_closes_it() {
    let room = |end: f64| {
        let block = |x: [f64; 2], y: [f64; 2], z: [f64; 2]| Body::Prism {
            corners: vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]],
            bottom: z[0],
            top: z[1],
        };
        let volumes = [
            volume(0, VolumeSide::KeepIn, block([0.0, 90.0], [0.0, 20.0], [0.0, 12.0])),
            volume(1, VolumeSide::KeepOut, block([30.0, 30.1], [0.0, end], [0.0, 12.0])),
            // It is not in the way.
            volume(2, VolumeSide::KeepOut, block([25.0, 26.0], [3.0, 4.0], [0.0, 12.0])),
        ];
        (volumes.iter().flat_map(|v| v.limits(SIZE)).collect::<Vec<Limit>>(), volumes)
    };
    let waypoints = [[20.0, 10.0, 5.0], [22.0, 10.0, 5.0], [40.0, 10.0, 5.0]].map(waypoint);
    let (limits, volumes) = room(19.5);
    let found = closed_off(&limits, &volumes, &waypoints).unwrap();
    assert_eq!(found.waypoint, 2);
    let by: Vec<u32> = found.by.iter().map(|&i| limits[i].span.start).collect();
    assert_eq!(by, [0, 1]);
    let (wider, others) = room(19.3);
    assert_eq!(closed_off(&wider, &others, &waypoints), None);
    assert_eq!(closed_off(&limits, &volumes, &waypoints[..2]), None);
}
