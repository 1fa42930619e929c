//! Divides a simple polygon into convex parts: ears are cut off (Meisters, *Polygons have ears*, 1975), and the
//! triangles are merged while they stay convex (Hertel and Mehlhorn, 1983).

/// Corners of a polygon, m.
type Polygon = Vec<[f64; 2]>;

/// Convex polygons, counter-clockwise, whose union is the polygon with these corners; one if it is convex. An error
/// says why the corners bound no area.
pub fn convex_parts(corners: &[[f64; 2]]) -> Result<Vec<Polygon>, String> {
    let n = corners.len();
    if let Some(i) = (0..n).find(|&i| corners[i] == corners[(i + 1) % n]) {
        return Err(format!("corners {} and {} are the same point", i + 1, (i + 1) % n + 1));
    }
    for i in 0..n {
        for j in i + 1..n {
            let are_neighbours = j == i + 1 || (i == 0 && j == n - 1);
            let [a, b, c, d] = [i, (i + 1) % n, j, (j + 1) % n].map(|k| corners[k]);
            if are_neighbours {
                // Neighbours share a corner; they may not fold back onto each other.
                let (before, at, after) = if j == i + 1 { (a, b, d) } else { (c, d, b) };
                let forward = (at[0] - before[0]) * (after[0] - at[0]) + (at[1] - before[1]) * (after[1] - at[1]);
                if turn(before, at, after) == 0.0 && forward < 0.0 {
                    return Err(format!(
                        "the edges at corner {} lie on each other",
                        if j == i + 1 { j + 1 } else { 1 }
                    ));
                }
            } else if cross_each_other(a, b, c, d) {
                return Err(format!("the edges after corners {} and {} meet", i + 1, j + 1));
            }
        }
    }
    let area: f64 = (0..n).map(|i| turn([0.0; 2], corners[i], corners[(i + 1) % n])).sum();
    if area == 0.0 || !area.is_finite() {
        return Err("their area is zero".into());
    }
    let mut polygon: Polygon = corners.to_vec();
    if area < 0.0 {
        polygon.reverse();
    }
    if is_convex(&polygon) {
        return Ok(vec![without_straight(polygon)]);
    }
    merged(ears(polygon)).ok_or("rounding leaves no part of it".into())
}

/// Twice the signed area of the triangle a, b, c: positive for a turn to the left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the closed segments a b and c d have a common point.
fn cross_each_other(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> bool {
    let on = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        turn(a, b, p) == 0.0 && (0..2).all(|i| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]))
    };
    let opposite = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b))
        || on(c, a, b)
        || on(d, a, b)
        || on(a, c, d)
        || on(b, c, d)
}

fn is_convex(polygon: &Polygon) -> bool {
    let n = polygon.len();
    (0..n).all(|i| turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) >= 0.0)
}

/// The polygon without corners on a straight edge.
fn without_straight(polygon: Polygon) -> Polygon {
    let n = polygon.len();
    let bends = |i: usize| turn(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]) != 0.0;
    (0..n).filter(|&i| bends(i)).map(|i| polygon[i]).collect()
}

/// Triangles of a simple polygon, counter-clockwise.
fn ears(mut polygon: Polygon) -> Vec<Polygon> {
    let mut triangles = Vec::new();
    while polygon.len() > 3 {
        let n = polygon.len();
        let corner = |i: usize| [(i + n - 1) % n, i, (i + 1) % n].map(|k| polygon[k]);
        let holds_none = |i: usize| {
            let [a, b, c] = corner(i);
            let inside = |p: &[f64; 2]| turn(a, b, *p) >= 0.0 && turn(b, c, *p) >= 0.0 && turn(c, a, *p) >= 0.0;
            polygon.iter().filter(|p| ![a, b, c].contains(p)).all(|p| !inside(p))
        };
        let area = |i: usize| {
            let [a, b, c] = corner(i);
            turn(a, b, c)
        };
        let ear = (0..n).find(|&i| area(i) > 0.0 && holds_none(i));
        // A corner on a straight edge, or one that rounding leaves, has no area.
        let Some(ear) = ear.or_else(|| (0..n).find(|&i| area(i) == 0.0)) else { return triangles };
        if area(ear) > 0.0 {
            triangles.push(corner(ear).to_vec());
        }
        polygon.remove(ear);
    }
    if turn(polygon[0], polygon[1], polygon[2]) > 0.0 {
        triangles.push(polygon);
    }
    triangles
}

/// The parts with neighbours merged while the result is convex; `None` for no part.
fn merged(mut parts: Vec<Polygon>) -> Option<Vec<Polygon>> {
    let both = |parts: &[Polygon], i: usize, j: usize| joined(&parts[i], &parts[j]).filter(is_convex);
    // In the order of the first pair that can be merged. No two of the parts before i can be: only a part that has
    // changed is looked at again.
    let mut i = 0;
    while i < parts.len() {
        let Some((j, merged)) = (i + 1..parts.len()).find_map(|j| Some((j, both(&parts, i, j)?))) else {
            i += 1;
            continue;
        };
        parts[i] = merged;
        parts.remove(j);
        while let Some((before, merged)) = (0..i).find_map(|before| Some((before, both(&parts, before, i)?))) {
            parts[before] = merged;
            parts.remove(i);
            i = before;
        }
    }
    (!parts.is_empty()).then(|| parts.into_iter().map(without_straight).collect())
}

/// The union of two polygons that share an edge.
fn joined(a: &Polygon, b: &Polygon) -> Option<Polygon> {
    let (n, m) = (a.len(), b.len());
    let (i, j) = (0..n).flat_map(|i| (0..m).map(move |j| (i, j))).find(|&(i, j)| {
        // The edge from corner i of a is that to corner j of b, the other way round.
        a[i] == b[(j + 1) % m] && a[(i + 1) % n] == b[j]
    })?;
    let of_a = (0..n).map(|k| a[(i + 1 + k) % n]);
    let of_b = (2..m).map(|k| b[(j + k) % m]);
    Some(of_a.chain(of_b).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &Polygon) -> f64 {
        let n = polygon.len();
        0.5 * (0..n).map(|i| turn([0.0; 2], polygon[i], polygon[(i + 1) % n])).sum::<f64>()
    }

    #[test]
    fn parts_are_convex_and_have_the_whole_area() {
        let ell = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        let star: Polygon = (0..14)
            .map(|i| {
                let (r, angle) = (if i % 2 == 0 { 3.0 } else { 1.0 }, f64::from(i) * std::f64::consts::TAU / 14.0);
                [r * angle.cos(), r * angle.sin()]
            })
            .collect();
        let comb = vec![
            [0., 0.],
            [7., 0.],
            [7., 3.],
            [6., 3.],
            [6., 1.],
            [4., 1.],
            [4., 3.],
            [3., 3.],
            [3., 1.],
            [1., 1.],
            [1., 3.],
            [0., 3.],
        ];
        for polygon in [ell, star, comb] {
            for flipped in [false, true] {
                let mut given = polygon.clone();
                if flipped {
                    given.reverse();
                }
                let parts = convex_parts(&given).unwrap();
                assert!(parts.len() > 1 && parts.len() < polygon.len() - 2, "{parts:?}");
                assert!(parts.iter().all(|part| is_convex(part) && area(part) > 0.0), "{parts:?}");
                let sum: f64 = parts.iter().map(area).sum();
                assert!((sum - area(&polygon)).abs() < 1e-12, "{sum}");
            }
        }
        let square = [[0.0, 0.0], [0.0, 2.0], [1.0, 2.0], [2.0, 2.0], [2.0, 0.0]];
        assert_eq!(convex_parts(&square).unwrap(), vec![vec![[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]]);
    }

    /// The parts are those of the plain search, which begins anew after each merge.
    #[test]
    fn pairs_are_merged_in_the_same_order() {
        let mut seed = 5_u64;
        let mut number = || {
            seed = seed * 48_271 % 0x7fff_ffff;
            seed as f64 / f64::from(0x7fff_ffff)
        };
        for corners in [9, 30, 60] {
            let at = |i: usize, r: f64| {
                let angle = i as f64 * std::f64::consts::TAU / corners as f64;
                [r * angle.cos(), r * angle.sin()]
            };
            let triangles = ears((0..corners).map(|i| at(i, 1.0 + number())).collect());
            let mut plain = triangles.clone();
            while let Some((i, j, both)) = (0..plain.len())
                .flat_map(|i| (i + 1..plain.len()).map(move |j| (i, j)))
                .find_map(|(i, j)| Some((i, j, joined(&plain[i], &plain[j]).filter(is_convex)?)))
            {
                plain[i] = both;
                plain.remove(j);
            }
            let plain: Vec<Polygon> = plain.into_iter().map(without_straight).collect();
            assert!(plain.len() < triangles.len());
            assert_eq!(merged(triangles).unwrap(), plain);
        }
    }

    #[test]
    fn corners_that_bound_nothing_are_refused() {
        let refused = |corners: &[[f64; 2]]| convex_parts(corners).unwrap_err();
        assert!(refused(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).contains("2 and 3 are the same"));
        assert!(refused(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]).contains("meet"));
        assert!(refused(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).contains("lie on each other"));
        assert!(refused(&[[0.0, 0.0], [4.0, 0.0], [1.0, 0.0], [1.0, 3.0]]).contains("lie on each other"));
    }
}
