#pragma once
// What each room of the core offers in Python; module.cpp puts them together, lower floors first.

namespace pybind11 {
class module_;
}

namespace glisson::python {

void add_imaging(pybind11::module_& module);
void add_geometry(pybind11::module_& module);
void add_segmentation(pybind11::module_& module);
void add_elastography(pybind11::module_& module);
void add_mechanics(pybind11::module_& module);
void add_hardware(pybind11::module_& module);
void add_meshing(pybind11::module_& module);
void add_registration(pybind11::module_& module);
void add_registration_quality(pybind11::module_& module);
void add_rehearsal(pybind11::module_& module);
void add_vision(pybind11::module_& module);
void add_vasculature(pybind11::module_& module);
void add_planning(pybind11::module_& module);
void add_guidance(pybind11::module_& module);
void add_closedloop(pybind11::module_& module);
void add_casefile(pybind11::module_& module);
void add_growth(pybind11::module_& module);
void add_scene(pybind11::module_& module);
void add_report(pybind11::module_& module);

}  // namespace glisson::python
