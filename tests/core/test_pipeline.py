"""The paper's Section 5.1 and the key numbers of the published workbooks, as facts."""

import numpy as np
import pytest
from hypothesis import given, settings

from qovr_core import FORMULATIONS, Document, Evaluation, Formulation, configure, edits
from qovr_core.geometry.alignment import align
from qovr_core.presets import preset
from support.documents import documents, random_document, random_net


def test_section_5_1():
    surface = configure(preset("fig5").document)
    assert surface.control_box == pytest.approx(np.array([[0, 4], [0, 4], [0.4, 0.5]]))
    assert surface.raw_box == pytest.approx(np.array([[10, 30], [20, 60], [0.88, 1.2]]), abs=1e-9)
    matrix = [[0.2, 0, 0, -2], [0, 0.1, 0, -2], [0, 0, 0.3125, 0.125], [0, 0, 0, 1]]
    assert surface.matrix == pytest.approx(np.array(matrix), abs=1e-9)


def test_the_published_numbers_of_figure_6b():
    surface = configure(preset("fig6b").document)
    assert surface.raw[0, 0] == pytest.approx([10.000500006089998, 20.001000012179997, 0.8800432805289398], abs=1e-9)
    assert surface.raw[0, 1] == pytest.approx([10.000501007919848, 20.763226499083295, 0.8793828196859719], abs=1e-9)
    assert surface.raw[-1, -1] == pytest.approx([30.00118001155, 60.0023600231, 0.88004328052894], abs=1e-9)
    box = [[10.00029, 30.001183725896496], [20.00058, 60.00236745179299], [0.8643883946284681, 1.2]]
    assert surface.raw_box == pytest.approx(np.array(box), abs=1e-9)
    scale = [0.19999106314039014, 0.09999553157019507, 0.29796347444331406]
    assert np.diag(surface.matrix)[:3] == pytest.approx(scale, abs=1e-9)
    assert surface.transformed[0, 4] == pytest.approx([4e-05, 0.29193, 0.40443], abs=5.1e-6)


def test_the_published_numbers_of_figure_8():
    surface = configure(preset("fig8").document)
    assert surface.raw_box[2] == pytest.approx([0.7334449664, 1.5], abs=1e-9)
    assert surface.matrix[2, 2:] == pytest.approx([0.8479495554903366, -0.5219243332355049], abs=1e-9)
    assert surface.raw[0, 24] == pytest.approx([10, 29.6, 0.7610883584], abs=1e-9)


def test_the_double_sum_is_not_the_papers_box():
    surface = configure(edits.set_formulation(preset("fig5").document, Formulation.DOUBLE_SUM))
    assert surface.raw_box[:2] == pytest.approx(np.array([[50, 150], [50, 150]]))


def test_the_interpolating_surface_lies_on_the_inner_net():
    surface = configure(edits.set_formulation(preset("fig5").document, Formulation.INTERPOLATING))
    assert surface.raw_box[:2] == pytest.approx(np.array([[1, 3], [1, 3]]))


@given(documents(samples=(9, 14)))
@settings(max_examples=40, deadline=None)
def test_the_transformed_samples_fill_the_box_of_the_net(document):
    surface = configure(document)
    filled = np.stack([surface.transformed.min(axis=(0, 1)), surface.transformed.max(axis=(0, 1))], axis=1)
    assert filled == pytest.approx(surface.control_box, abs=1e-9)
    homogeneous = np.concatenate([surface.raw, np.ones((9, 14, 1))], axis=-1)
    assert (homogeneous @ surface.matrix.T)[..., :3] == pytest.approx(surface.transformed, abs=1e-9)


@pytest.mark.parametrize("samples", [(2, 2), (2, 4096), (101, 51), (3, 101)])
def test_samples_are_counted_from_end_to_end(samples):
    surface = configure(random_document(4, samples=samples))
    assert surface.raw.shape == surface.transformed.shape == (*samples, 3)
    for parameters, count in ((surface.u, samples[0]), (surface.v, samples[1])):
        assert len(parameters) == count
        assert parameters[0] == 0.0
        assert parameters[-1] == 1.0
    ends = surface.patch.coefficients[0, 0][[0, -1]][:, [0, -1]]
    assert surface.raw[[0, -1]][:, [0, -1]] == pytest.approx(ends, rel=1e-14)


def test_results_are_float64_read_only_and_the_same_again():
    document = random_document(5)
    first, second = configure(document), configure(document)
    for name in ("u", "v", "raw", "transformed", "control_box", "raw_box", "matrix"):
        array = getattr(first, name)
        assert array.dtype == np.float64
        assert not array.flags.writeable
        assert np.array_equal(array, getattr(second, name))


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_a_flat_net_keeps_its_height(formulation):
    net = random_net(6)
    net[..., 2] = 0.1 + 0.2
    surface = configure(Document(net, formulation=formulation))
    assert surface.flat_axes == ("z",)
    assert surface.matrix[2, 2] == 1
    assert surface.transformed[..., 2] == pytest.approx(np.full((101, 101), 0.3), abs=1e-12)


def test_a_raw_surface_without_extent_is_moved_and_not_scaled():
    net = random_net(7)
    net[4, :, 1] = 0.0  # the published surface takes y from row 4 alone
    surface = configure(Document(net))
    assert surface.flat_axes == ("y",)
    assert surface.matrix[1].tolist() == [0, 1, 0, surface.control_box[1, 0]]


def test_a_net_drawn_together_into_one_point():
    surface = configure(Document(np.full((5, 5, 3), 2.5)))
    assert surface.flat_axes == ("x", "y", "z")
    assert surface.transformed == pytest.approx(np.full((101, 101, 3), 2.5))


@pytest.mark.parametrize("samples", [(7, 5), (1200, 150), (101, 101)])
@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_the_aligned_patch_is_that_of_the_whole_pipeline(formulation, samples):
    document = random_document(9, formulation, samples)
    whole, light = configure(document), Evaluation(document)
    assert np.array_equal(light.patch.coefficients[0, 0], whole.patch.coefficients[0, 0])
    assert light.raw_box == pytest.approx(whole.raw_box, rel=1e-14)
    assert light.matrix == pytest.approx(whole.matrix, rel=1e-12)
    assert light.transformed_patch.points(whole.u, whole.v) == pytest.approx(whole.transformed, abs=1e-12)
    assert light.flat_axes == whole.flat_axes


def test_alignment_by_hand():
    raw_box = np.array([[1.0, 3.0], [-1.03125, -0.96875], [0.0, 10.0]])
    control_box = np.array([[0.0, 1.0], [5.0, 6.0], [4.0, 4.0]])
    alignment = align(raw_box, control_box, [0.1, 0.1, 0.1])
    assert alignment.flat_axes == ("y",)
    assert alignment.matrix.tolist() == [[0.5, 0, 0, -0.5], [0, 1, 0, 6.03125], [0, 0, 0, 4], [0, 0, 0, 1]]
