//! Random soups of polygons against slow twins.

use edgewalker::geom::{Collider, ExpandedEdge, Point, Source, check_outline, expand};
use edgewalker::mesh::Mesh;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

fn below(rng: &mut Pcg32, n: u32) -> i32 {
    (rng.next_u32() % n) as i32
}

fn wire(edges: &[(Point, Point)]) -> Vec<ExpandedEdge> {
    let edge = |(i, &(a, b)): (usize, &(Point, Point))| ExpandedEdge {
        a,
        b,
        source: Source::Edge { edge: i as u32 },
    };
    edges.iter().enumerate().map(edge).collect()
}

#[test]
fn small_soups() {
    let mut rng = Pcg32::new(1, 1);
    for round in 0..3000 {
        let n = 3 + below(&mut rng, 5) as usize;
        let size = 13;
        let mut features = Vec::new();
        for _ in 0..n {
            let p = |rng: &mut Pcg32| Point::new(below(rng, size) - 6, below(rng, size));
            let (a, b) = (p(&mut rng), p(&mut rng));
            if a != b {
                features.push(wire(&[(a, b)]));
            }
        }
        let mesh = Mesh::build(&features).unwrap();
        mesh.check()
            .unwrap_or_else(|e| panic!("round {round}: {e}\n{features:?}"));
        let hash = mesh.hash();
        let mut other = Mesh::build(&[]).unwrap();
        for (id, f) in features.iter().enumerate().rev() {
            other.insert(id as u32, f).unwrap();
            other
                .check()
                .unwrap_or_else(|e| panic!("round {round}, inserting {id}: {e}\n{features:?}"));
        }
        assert_eq!(hash, other.hash(), "round {round} {features:?}");
        for id in 0..features.len() {
            other.remove(id as u32).unwrap();
            other
                .check()
                .unwrap_or_else(|e| panic!("round {round}, removing {id}: {e}\n{features:?}"));
        }
        assert_eq!(Mesh::build(&[]).unwrap().hash(), other.hash());
    }
}

#[test]
fn polygon_soups() {
    let mut rng = Pcg32::new(2, 1);
    for round in 0..300 {
        let mut features = Vec::new();
        for _ in 0..6 {
            let (cx, cy) = (below(&mut rng, 40), below(&mut rng, 40));
            let outline: Vec<Point> = (0..3 + below(&mut rng, 3))
                .map(|_| Point::new(cx + below(&mut rng, 20), cy + below(&mut rng, 20)))
                .collect();
            if check_outline(&outline).is_ok() {
                let c = Collider::new(vec![
                    Point::new(-2, 0),
                    Point::new(2, 0),
                    Point::new(3, 4),
                    Point::new(-3, 4),
                ])
                .unwrap();
                features.push(expand(&outline, &c));
            }
        }
        let mesh = Mesh::build(&features).unwrap();
        mesh.check()
            .unwrap_or_else(|e| panic!("round {round}: {e}"));
        let mut other = Mesh::build(&[]).unwrap();
        for (id, f) in features.iter().enumerate().rev() {
            other.insert(id as u32, f).unwrap();
            other
                .check()
                .unwrap_or_else(|e| panic!("round {round}, inserting {id}: {e}"));
        }
        assert_eq!(mesh.hash(), other.hash(), "round {round}");
        for id in 0..features.len() {
            other.remove(id as u32).unwrap();
            other
                .check()
                .unwrap_or_else(|e| panic!("round {round}, removing {id}: {e}"));
        }
    }
}
