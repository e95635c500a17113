#include "hardware/device_file.h"

#include <algorithm>
#include <set>

#include "hardware/internal/device_figures.h"
#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr const char* devices_format = "glisson-devices/1";
constexpr std::size_t maximum_devices = 1000;
constexpr std::size_t maximum_table_points = 10000;

std::vector<Device> devices_from(const Json& document, const std::filesystem::path& file);
Device device_from(const Json& object, std::size_t index);
void read_figures(const Json& object, const std::string& where, Device& device);
void read_measured(const Json& kernel, const std::string& where, Device& device);
void refuse_unknown(const Json& object, const std::string& where);
Worn worn_from(const Json& object, const std::string& where);
bool is_plain(const std::string& id);
Json as_json(const Device& device);

}  // namespace

Result<std::vector<Device>> read_devices(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  return reading("devices-invalid", file, [&] { return devices_from(*document, file); });
}

void take_in(std::vector<Device> more, std::vector<Device>& devices) {
  for (Device& device : more) {
    const auto same =
        std::find_if(devices.begin(), devices.end(), [&](const Device& known) { return known.id == device.id; });
    if (same == devices.end()) {
      devices.push_back(std::move(device));
    } else {
      *same = std::move(device);
    }
  }
}

Result<void> write_devices(const std::filesystem::path& file, const std::vector<Device>& devices) {
  Json list = Json::array();
  for (const Device& device : devices) list.push_back(as_json(device));
  return write_json_file(file, Json{{"format", devices_format}, {"devices", list}});
}

namespace {

std::vector<Device> devices_from(const Json& document, const std::filesystem::path& file) {
  check_format(document, devices_format, file);
  const auto list = document.find("devices");
  if (list == document.end() || !list->is_array() || list->empty() || list->size() > maximum_devices) {
    refuse("devices-missing", GLISSON_TEXT("{0} has no list \"devices\" of 1 to {1} devices."),
           {file.string(), std::to_string(maximum_devices)});
  }
  std::vector<Device> devices;
  std::set<std::string> ids;
  for (const Json& object : *list) {
    devices.push_back(device_from(object, devices.size()));
    if (!ids.insert(devices.back().id).second) {
      refuse("device-twice", GLISSON_TEXT("Two devices have the id \"{0}\"."), {devices.back().id},
             GLISSON_TEXT("Give each its own."));
    }
  }
  return devices;
}

Device device_from(const Json& object, std::size_t index) {
  std::string where = "Device " + std::to_string(index + 1);
  if (!object.is_object()) {
    refuse("json-not-an-object", GLISSON_TEXT("{0} should be an object in braces."), {where});
  }
  Device device;
  device.id = text_under(object, "id", where);
  if (!is_plain(device.id)) {
    refuse("device-id-invalid", GLISSON_TEXT("{0} has the id \"{1}\"."), {where, device.id},
           GLISSON_TEXT("Use up to 64 small letters, digits and dashes."));
  }
  where = "Device " + device.id;
  refuse_unknown(object, where);
  device.name = text_under(object, "name", where);
  device.worn = worn_from(object, where);
  device.worn_how = text_under(object, "worn_how", where);
  read_figures(object, where, device);
  read_measured(object.at("kernel"), where, device);
  if (auto checked = check(device); !checked) throw Refusal{std::move(checked.error())};
  return device;
}

void read_figures(const Json& object, const std::string& where, Device& device) {
  for (const FigureSlot& slot : figure_slots()) {
    const bool grouped = *slot.group != '\0';
    const auto group = grouped ? object.find(slot.group) : object.end();
    if (grouped && (group == object.end() || !group->is_object())) refuse_missing(slot.group, where);
    const Json& holder = grouped ? *group : object;
    if (slot.ideal && !holder.contains(slot.name)) {
      slot.of(device) = {*slot.ideal, Source::assumed, "not stated: taken as ideal"};
      continue;
    }
    slot.of(device) = figure_under(holder, slot.name, {slot.minimum, slot.maximum}, where);
  }
}

void read_measured(const Json& kernel, const std::string& where, Device& device) {
  const auto measured = kernel.find("measured");
  if (measured == kernel.end()) return;
  const std::string here = where + ", kernel.measured";
  known_keys(*measured, {"nodes_in_domain", "points"}, here);
  device.kernel.measured_nodes_in_domain = static_cast<int>(number_under(*measured, "nodes_in_domain", {1, 125}, here));
  const auto points = measured->find("points");
  if (points == measured->end() || !points->is_array() || points->size() > maximum_table_points)
    refuse_missing("points", here);
  for (const Json& point : *points) {
    known_keys(point, {"nodes", "seconds", "joules"}, here);
    MeasuredProduct product;
    product.nodes = number_under(point, "nodes", {1, 1e12}, here);
    product.seconds = number_under(point, "seconds", {1e-12, 1e6}, here);
    if (point.contains("joules")) product.joules = number_under(point, "joules", {1e-15, 1e9}, here);
    device.kernel.measured.push_back(product);
  }
}

void refuse_unknown(const Json& object, const std::string& where) {
  known_keys(object,
             {"id", "name", "worn", "worn_how", "idle_W", "supply_efficiency", "thermal_resistance_C_per_W",
              "thermal_time_constant_s", "throttle_C", "battery", "kernel"},
             where);
  if (!object.contains("battery")) refuse_missing("battery", where);
  known_keys(object.at("battery"),
             {"capacity_mAh", "voltage_V", "internal_resistance_ohm", "rate_exponent", "capacity_per_C"},
             where + ", battery");
  if (!object.contains("kernel")) refuse_missing("kernel", where);
  known_keys(object.at("kernel"),
             {"bandwidth_GB_s", "peak_GFLOPS", "fast_memory_MB", "fast_bandwidth_GB_s", "launch_us", "tile_nodes",
              "active_W", "energy_nJ_per_byte", "measured"},
             where + ", kernel");
}

Worn worn_from(const Json& object, const std::string& where) {
  const std::string name = text_under(object, "worn", where);
  for (const Worn worn : {Worn::head, Worn::belt, Worn::back}) {
    if (name == to_string(worn)) return worn;
  }
  refuse("worn-unknown", GLISSON_TEXT("{0} is worn \"{1}\"."), {where, name}, GLISSON_TEXT("Use head, belt or back."));
}

bool is_plain(const std::string& id) {
  return id.size() <= 64 && std::all_of(id.begin(), id.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
         });
}

Json as_json(const Device& device) {
  Json object{
      {"id", device.id}, {"name", device.name}, {"worn", to_string(device.worn)}, {"worn_how", device.worn_how}};
  for (const FigureSlot& slot : figure_slots()) {
    const Figure& figure = slot.of_const(device);
    const Json written{{"value", figure.value}, {"source", to_string(figure.source)}, {"note", figure.note}};
    (*slot.group == '\0' ? object : object[slot.group])[slot.name] = written;
  }
  if (!device.kernel.measured.empty()) {
    Json points = Json::array();
    for (const MeasuredProduct& product : device.kernel.measured) {
      Json point{{"nodes", product.nodes}, {"seconds", product.seconds}};
      if (product.joules) point["joules"] = *product.joules;
      points.push_back(point);
    }
    object["kernel"]["measured"] =
        Json{{"nodes_in_domain", device.kernel.measured_nodes_in_domain}, {"points", points}};
  }
  return object;
}

}  // namespace
}  // namespace glisson::hardware
