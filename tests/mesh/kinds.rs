//! Solids, one-ways and regions in one mesh: what each covers, what each stops, and that edits of all three equal a
//! rebuild.

use crate::common::slow::{self, spot};
use crate::common::soups::{polygons, segments, small_collider, snapped_outline, sound};
use crate::common::worlds::{Dice, wire};
use edgewalker::geom::{Collider, ExpandedEdge, Point, expand};
use edgewalker::mesh::{FeatureId, Kind, Mesh, MeshError};

/// A feature with its id and kind, as [`Mesh::of`] takes it.
type Entry = (FeatureId, Kind, Vec<ExpandedEdge>);

/// Polygons that are solids or regions by turns, and loose segments as one-ways between them.
fn mixed(dice: &mut Dice, n: usize) -> Vec<Entry> {
    let outlines = polygons(dice, n, &small_collider());
    let mut entry = |(id, outline): (u32, Vec<ExpandedEdge>)| match id % 3 {
        0 => (id, Kind::Solid, outline),
        1 => (id, Kind::Region, outline),
        _ => (id, Kind::OneWay, wire(&segments(dice))),
    };
    (0..).zip(outlines).map(&mut entry).collect()
}

/// Asserts covers, solidity and fronts against outlines and segments taken one by one.
fn kinds_agree(mesh: &Mesh, entries: &[Entry], story: &dyn std::fmt::Debug) {
    sound(mesh, story);
    let closed: Vec<_> = entries.iter().filter(|e| e.1 != Kind::OneWay).collect();
    for face in mesh.faces() {
        let corners = mesh.corners(face).map(spot);
        let centre = corners.iter().fold((0, 0), |s, c| (s.0 + c.0, s.1 + c.1));
        let winds = |e: &&&Entry| slow::winding(&snapped_outline(mesh, e.0), centre) > 0;
        let around: Vec<&&Entry> = closed.iter().filter(winds).collect();
        let mut ids: Vec<FeatureId> = around.iter().map(|e| e.0).collect();
        ids.sort_unstable();
        assert_eq!(mesh.cover(face), ids, "{corners:?}\n{story:?}");
        let solid = around.iter().any(|e| e.1 == Kind::Solid);
        assert_eq!(mesh.is_solid(face), solid, "{corners:?}\n{story:?}");
    }
    for (id, kind, edges) in entries {
        assert_eq!(mesh.kind_of(*id), Some(*kind));
        assert_eq!(mesh.segments_of(*id).len(), edges.len());
        for &s in mesh.segments_of(*id) {
            assert_eq!(mesh.kind(s), *kind);
            for pair in mesh.chain(s).windows(2) {
                let e = mesh.edge_between(pair[1], pair[0]).unwrap();
                let front = mesh.fronts(e).any(|front| front == s);
                assert_eq!(
                    front,
                    *kind == Kind::OneWay,
                    "a one-way has its front right of its edges"
                );
                assert!(mesh.has_front(e) || *kind != Kind::OneWay);
            }
        }
    }
}

#[test]
fn mixed_kinds_agree_with_their_outlines_through_edits() {
    for seed in 0..150 {
        let mut dice = Dice::new(seed);
        let entries = mixed(&mut dice, 9);
        let mut mesh = Mesh::of(&entries).unwrap();
        kinds_agree(&mesh, &entries, &seed);
        let before = mesh.hash();
        let mut rest = entries.clone();
        for _ in 0..4 {
            let (id, _, _) = rest.swap_remove(dice.below(rest.len() as u32) as usize);
            mesh.remove(id).unwrap();
            assert_eq!(mesh.kind_of(id), None);
            kinds_agree(&mesh, &rest, &(seed, id));
            assert_eq!(mesh.hash(), Mesh::of(&rest).unwrap().hash(), "seed {seed}");
        }
        for (id, kind, edges) in entries.iter().rev() {
            let gone = !rest.iter().any(|e| e.0 == *id);
            let expected = if gone {
                Ok(())
            } else {
                Err(MeshError::Occupied { feature: *id })
            };
            assert_eq!(mesh.insert_as(*id, *kind, edges), expected);
        }
        assert_eq!(mesh.hash(), before, "seed {seed}");
    }
}

#[test]
fn one_id_can_change_its_kind() {
    let square = [(0, 0), (40, 0), (40, 40), (0, 40)].map(|(x, y)| Point::new(x, y));
    let edges = expand(&square, &Collider::point());
    let mut mesh = Mesh::build(&[]).unwrap();
    let mut hashes = Vec::new();
    for kind in [
        Kind::Solid,
        Kind::Region,
        Kind::OneWay,
        Kind::Line,
        Kind::Solid,
    ] {
        mesh.insert_as(7, kind, &edges).unwrap();
        sound(&mesh, &kind);
        let covered = mesh.faces().filter(|&f| mesh.cover(f) == [7]).count();
        let solid = mesh.faces().filter(|&f| mesh.is_solid(f)).count();
        let blocking = mesh.edges().flat_map(|e| [e, mesh.sym(e)]);
        let blocking = blocking.filter(|&e| mesh.blocks(e) && mesh.left(mesh.sym(e)).is_some());
        let fronts = mesh.edges().flat_map(|e| [e, mesh.sym(e)]);
        let found = (
            covered,
            solid,
            blocking.count(),
            fronts.filter(|&e| mesh.has_front(e)).count(),
        );
        let expected = match kind {
            Kind::Solid => (2, 2, 4, 0),
            Kind::Region => (2, 0, 0, 0),
            Kind::OneWay | Kind::Line => (0, 0, 0, 4),
        };
        assert_eq!(found, expected, "{kind:?}");
        hashes.push(mesh.hash());
        mesh.remove(7).unwrap();
    }
    assert_eq!(hashes[0], hashes[4]);
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), 4, "the hash tells kinds apart");
}

#[test]
fn equal_ids_are_refused() {
    let one = |id| {
        (
            id,
            Kind::Region,
            wire(&[(Point::new(0, 0), Point::new(id as i32 + 1, 5))]),
        )
    };
    assert_eq!(
        Mesh::of(&[one(4), one(9), one(4)]).unwrap_err(),
        MeshError::Occupied { feature: 4 }
    );
}

#[test]
fn covers_that_are_gone_leave_room_for_others() {
    // A box that wanders among others, so that the overlaps differ each time.
    let mut dice = Dice::new(11);
    let features = polygons(&mut dice, 12, &small_collider());
    let mut mesh = Mesh::build(&features).unwrap();
    let mut most = 0;
    for round in 0..2000 {
        let corner = |x, y| Point::new(x + round % 23 - 8, y + round / 23 % 19 - 4);
        let square = [corner(0, 0), corner(9, 0), corner(9, 9), corner(0, 9)];
        let id = 100 + round as u32;
        mesh.insert(id, &expand(&square, &Collider::point()))
            .unwrap();
        if round < 500 {
            most = most.max(mesh.cover_room());
        }
        mesh.remove(id).unwrap();
    }
    sound(&mesh, &"wandered");
    assert_eq!(mesh.hash(), Mesh::build(&features).unwrap().hash());
    assert!(
        mesh.cover_room() <= most + most / 4,
        "{} after 2000 edits, {most} in the first 500",
        mesh.cover_room()
    );
}
