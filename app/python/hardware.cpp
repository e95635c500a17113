// What a surgeon can wear for a case.

#include <dlfcn.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "base/files.h"
#include "hardware/convergence_curve.h"
#include "hardware/device_file.h"
#include "hardware/plan.h"
#include "long_call.h"
#include "rooms.h"

namespace py = pybind11;
using namespace py::literals;

namespace glisson::python {
namespace {

using namespace hardware;

struct Tables {
  std::vector<Device> devices;
  ConvergenceCurve curve;
};

// The core looks beside the program that runs, which is the interpreter; this looks beside the package as well.
Result<std::filesystem::path> shipped() {
  auto found = resource_folder();
  if (found) return found;
  Dl_info module{};
  if (dladdr(reinterpret_cast<const void*>(&shipped), &module) == 0 || module.dli_fname == nullptr) return found;
  std::error_code problem;
  const auto file = std::filesystem::canonical(module.dli_fname, problem);
  for (auto folder = file.parent_path(); folder != folder.parent_path(); folder = folder.parent_path()) {
    for (const auto& resources : {folder / "resources", folder / "share" / "glisson" / "resources"})
      if (std::filesystem::is_directory(resources / "devices", problem)) return resources;
  }
  return found;
}

// The shipped ones; a device of the user's takes the place of a shipped one with its id.
Result<Tables> tables(const std::vector<std::filesystem::path>& more_devices) {
  const auto resources = shipped();
  if (!resources) return failure(resources.error());
  auto devices = read_devices(*resources / "devices" / "devices.json");
  if (!devices) return failure(devices.error());
  for (const auto& file : more_devices) {
    auto more = read_devices(file);
    if (!more) return failure(more.error());
    take_in(*std::move(more), *devices);
  }
  auto curve = read_convergence_curve(*resources / "devices" / "convergence.json");
  if (!curve) return failure(curve.error());
  return Tables{*std::move(devices), *std::move(curve)};
}

py::dict dict_of(const DevicePlan& answer) {
  py::dict dict;
  dict["id"] = answer.id;
  dict["name"] = answer.name;
  dict["worn"] = to_string(answer.worn);
  dict["feasible"] = answer.feasible;
  dict["fps"] = answer.fps;
  dict["power_W"] = answer.power_W;
  dict["battery_h"] = answer.battery_h;
  dict["temperature_C"] = answer.temperature_C;
  dict["headroom_W"] = answer.idle.headroom_W;
  std::vector<std::string> reasons;
  for (const Reason& reason : answer.reasons) reasons.push_back(reason.sentence.message());
  dict["reasons"] = reasons;
  dict["assumed"] = answer.assumed;
  return dict;
}

py::dict planned(double liver_volume_cm3, double accuracy_mm, const std::optional<double>& youngs_kPa,
                 double duration_h, double frames_per_s, double ambient_C, double limit_C,
                 const std::vector<std::filesystem::path>& devices) {
  PlanRequest request;
  request.liver_volume_cm3 = liver_volume_cm3;
  request.accuracy_mm = accuracy_mm;
  request.youngs_kPa = youngs_kPa;
  request.duration_h = duration_h;
  request.frames_per_s = frames_per_s;
  request.ambient_C = ambient_C;
  request.limit_C = limit_C;
  const Plan found = short_call([&] {
    return tables(devices).and_then([&](const Tables& all) { return plan(request, all.devices, all.curve); });
  });
  py::list platforms;
  for (const DevicePlan& answer : found.platforms) platforms.append(dict_of(answer));
  return py::dict("platforms"_a = platforms, "recommended"_a = found.recommended, "nodes"_a = found.workload.nodes,
                  "frame_flops"_a = found.workload.frame_flops, "frame_bytes"_a = found.workload.frame_bytes,
                  "notes"_a = messages(found.notes));
}

}  // namespace

void add_hardware(py::module_& module) {
  const PlanRequest usual;
  module.def("plan_hardware", &planned, py::kw_only(), py::arg("liver_volume_cm3"), py::arg("accuracy_mm"),
             py::arg("youngs_kPa") = py::none(), py::arg("duration_h") = usual.duration_h,
             py::arg("frames_per_s") = usual.frames_per_s, py::arg("ambient_C") = usual.ambient_C,
             py::arg("limit_C") = usual.limit_C, py::arg("devices") = std::vector<std::filesystem::path>(),
             R"(The least obtrusive wearable computer that holds for a case, and why others fail.

A dict: platforms, a dict each (id, name, worn, feasible, fps: what it can hold, power_W, battery_h, temperature_C,
headroom_W, reasons, assumed); recommended (an id or None); nodes, frame_flops, frame_bytes; notes.
devices: further device tables (JSON files).

Raises glisson.Error: request-invalid, volume-not-a-liver, accuracy-not-reached, resources-missing.)");
}

}  // namespace glisson::python
