//! A largest independent set of a bipartite graph: a maximum matching by Hopcroft and Karp (1973, SIAM J. Comput.
//! 2(4)), then the complement of König's smallest cover.

use std::collections::VecDeque;

const NONE: u32 = u32::MAX;

/// Which vertices on the right are in a largest set of vertices without an edge between them. `edges[i]` lists the
/// neighbours on the right of the vertex `i` on the left. O(E sqrt(V)).
pub fn independent_on_the_right(edges: &[Vec<u32>], right: usize) -> Vec<bool> {
    let mut left_of = vec![NONE; right];
    let mut right_of = vec![NONE; edges.len()];
    let mut levels = vec![NONE; edges.len()];
    loop {
        // Breadth first from the unmatched vertices on the left.
        let mut queue: VecDeque<u32> = VecDeque::new();
        for (i, level) in levels.iter_mut().enumerate() {
            *level = if right_of[i] == NONE { 0 } else { NONE };
            if *level == 0 {
                queue.push_back(i as u32);
            }
        }
        let mut can_grow = false;
        while let Some(i) = queue.pop_front() {
            for &j in &edges[i as usize] {
                match left_of[j as usize] {
                    NONE => can_grow = true,
                    next if levels[next as usize] == NONE => {
                        levels[next as usize] = levels[i as usize] + 1;
                        queue.push_back(next);
                    }
                    _ => {}
                }
            }
        }
        if !can_grow {
            break;
        }
        let mut next_edge = vec![0; edges.len()];
        for i in 0..edges.len() {
            if right_of[i] == NONE {
                augment(i as u32, edges, &mut left_of, &mut right_of, &mut levels, &mut next_edge);
            }
        }
    }
    // The last search has no augmenting path: what it reached on the left is independent, with what it did not reach on
    // the right.
    let mut reached = vec![false; right];
    for (i, neighbours) in edges.iter().enumerate() {
        if levels[i] != NONE {
            neighbours.iter().for_each(|&j| reached[j as usize] = true);
        }
    }
    reached.iter().map(|reached| !reached).collect()
}

/// Matches one more vertex along a shortest path, if there is one; depth first, without recursion.
fn augment(
    from: u32,
    edges: &[Vec<u32>],
    left_of: &mut [u32],
    right_of: &mut [u32],
    levels: &mut [u32],
    next_edge: &mut [usize],
) {
    let mut path = vec![from];
    while let Some(&i) = path.last() {
        let at = i as usize;
        let Some(&j) = edges[at].get(next_edge[at]) else {
            levels[at] = NONE;
            path.pop();
            if let Some(&before) = path.last() {
                next_edge[before as usize] += 1;
            }
            continue;
        };
        match left_of[j as usize] {
            NONE => {
                for &i in &path {
                    let j = edges[i as usize][next_edge[i as usize]];
                    left_of[j as usize] = i;
                    right_of[i as usize] = j;
                }
                return;
            }
            next if levels[next as usize] == levels[at] + 1 => path.push(next),
            _ => next_edge[at] += 1,
        }
    }
}
