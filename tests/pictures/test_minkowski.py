"""The merge of the edges of two polygons."""

from itertools import islice, pairwise

from gen.geometry import hull
from pictures.minkowski import Source, merged, reflected
from stress.chance import random_scenarios


def test_the_merged_edges_go_round_the_hull_of_all_sums():
    polygons = [s.robot for s in islice(random_scenarios(3, 300), 300)]
    for a, b in pairwise(polygons):
        edges = list(merged(a, b))
        assert [e.end for e in edges] == [e.start for e in edges[1:] + edges[:1]]
        expected = hull([(px + qx, py + qy) for px, py in a for qx, qy in b])
        assert {e.start for e in edges} == set(expected)
        assert len(edges) == len(expected)
        shared = sum(e.source is Source.BOTH for e in edges)
        assert len(edges) == len(a) + len(b) - shared


def test_reflection():
    assert reflected([(1, 2), (3, 4)]) == [(-1, -2), (-3, -4)]
