#include "hardware/device_file.h"

#include <algorithm>
#include <set>

#include "base/json.h"
#include "hardware/internal/device_figures.h"
#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr const char* format = "glisson-devices/1";
constexpr std::size_t maximum_devices = 1000;
constexpr std::size_t maximum_points = 10000;

Result<Device> read_device(const Json& object, std::size_t index, const FigureReader& reader);
Result<void> read_figures(const Json& object, const std::string& where, const FigureReader& reader, Device& device);
Result<void> read_measured(const Json& kernel, const std::string& where, const FigureReader& reader, Device& device);
Result<void> refuse_unknown(const Json& object, const std::string& where, const FigureReader& reader);
Result<Worn> read_worn(const Json& object, const std::string& where, const FigureReader& reader);
bool is_plain(const std::string& id);
Json as_json(const Device& device);

}  // namespace

Result<std::vector<Device>> read_devices(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  const auto reader = FigureReader::open(*document, format, file);
  if (!reader) return failure(reader.error());
  const auto list = document->find("devices");
  if (list == document->end() || !list->is_array() || list->empty() || list->size() > maximum_devices) {
    return failure(Error{"devices-missing",
                         GLISSON_TEXT("{0} has no list \"devices\" of 1 to {1} devices."),
                         {file.string(), std::to_string(maximum_devices)},
                         {},
                         file});
  }
  std::vector<Device> devices;
  std::set<std::string> ids;
  for (const Json& object : *list) {
    auto device = read_device(object, devices.size(), *reader);
    if (!device) return failure(device.error());
    if (!ids.insert(device->id).second) {
      return failure(Error{"device-twice",
                           GLISSON_TEXT("Two devices have the id \"{0}\"."),
                           {device->id},
                           GLISSON_TEXT("Give each its own."),
                           file});
    }
    devices.push_back(std::move(*device));
  }
  return devices;
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
  return write_json_file(file, Json{{"format", format}, {"devices", list}});
}

namespace {

Result<Device> read_device(const Json& object, std::size_t index, const FigureReader& reader) {
  std::string where = "Device " + std::to_string(index + 1);
  if (!object.is_object()) {
    return failure(
        Error{"json-not-an-object", GLISSON_TEXT("{0} should be an object in braces."), {where}, {}, reader.file()});
  }
  Device device;
  const auto id = reader.text(object, "id", where);
  if (!id) return failure(id.error());
  device.id = *id;
  if (!is_plain(*id)) {
    return failure(Error{"device-id-invalid",
                         GLISSON_TEXT("{0} has the id \"{1}\"."),
                         {where, *id},
                         GLISSON_TEXT("Use up to 64 small letters, digits and dashes."),
                         reader.file()});
  }
  where = "Device " + device.id;
  if (const auto known = refuse_unknown(object, where, reader); !known) return failure(known.error());
  const auto name = reader.text(object, "name", where);
  if (!name) return failure(name.error());
  device.name = *name;
  const auto worn = read_worn(object, where, reader);
  if (!worn) return failure(worn.error());
  device.worn = *worn;
  const auto worn_how = reader.text(object, "worn_how", where);
  if (!worn_how) return failure(worn_how.error());
  device.worn_how = *worn_how;
  if (const auto read = read_figures(object, where, reader, device); !read) return failure(read.error());
  if (const auto read = read_measured(object.at("kernel"), where, reader, device); !read) return failure(read.error());
  if (const auto checked = check(device); !checked) return failure(Error(checked.error()).in_file(reader.file()));
  return device;
}

Result<void> read_figures(const Json& object, const std::string& where, const FigureReader& reader, Device& device) {
  for (const FigureSlot& slot : figure_slots()) {
    const bool grouped = *slot.group != '\0';
    const auto group = grouped ? object.find(slot.group) : object.end();
    if (grouped && (group == object.end() || !group->is_object())) return reader.missing(slot.group, where);
    const Json& holder = grouped ? *group : object;
    if (slot.ideal && !holder.contains(slot.name)) {
      slot.of(device) = {*slot.ideal, Source::assumed, "not stated: taken as ideal"};
      continue;
    }
    auto figure = reader.figure(holder, slot.name, {slot.minimum, slot.maximum}, where);
    if (!figure) return failure(figure.error());
    slot.of(device) = std::move(*figure);
  }
  return {};
}

Result<void> read_measured(const Json& kernel, const std::string& where, const FigureReader& reader, Device& device) {
  const auto measured = kernel.find("measured");
  if (measured == kernel.end()) return {};
  const std::string here = where + ", kernel.measured";
  if (const auto known = refuse_unknown_keys(*measured, {"nodes_in_domain", "points"}, here); !known)
    return failure(Error(known.error()).in_file(reader.file()));
  const auto domain = reader.number(*measured, "nodes_in_domain", {1, 125}, here);
  if (!domain) return failure(domain.error());
  device.kernel.measured_nodes_in_domain = static_cast<int>(*domain);
  const auto points = measured->find("points");
  if (points == measured->end() || !points->is_array() || points->size() > maximum_points)
    return reader.missing("points", here);
  for (const Json& point : *points) {
    if (const auto known = refuse_unknown_keys(point, {"nodes", "seconds", "joules"}, here); !known)
      return failure(Error(known.error()).in_file(reader.file()));
    MeasuredProduct product;
    const auto nodes = reader.number(point, "nodes", {1, 1e12}, here);
    if (!nodes) return failure(nodes.error());
    product.nodes = *nodes;
    const auto seconds = reader.number(point, "seconds", {1e-12, 1e6}, here);
    if (!seconds) return failure(seconds.error());
    product.seconds = *seconds;
    if (point.contains("joules")) {
      const auto joules = reader.number(point, "joules", {1e-15, 1e9}, here);
      if (!joules) return failure(joules.error());
      product.joules = *joules;
    }
    device.kernel.measured.push_back(product);
  }
  return {};
}

Result<void> refuse_unknown(const Json& object, const std::string& where, const FigureReader& reader) {
  const auto in_file = [&reader](const Error& error) { return failure(Error(error).in_file(reader.file())); };
  if (const auto known = refuse_unknown_keys(
          object,
          {"id", "name", "worn", "worn_how", "idle_W", "supply_efficiency", "thermal_resistance_C_per_W",
           "thermal_time_constant_s", "throttle_C", "battery", "kernel"},
          where);
      !known)
    return in_file(known.error());
  if (!object.contains("battery")) return reader.missing("battery", where);
  if (const auto known = refuse_unknown_keys(
          object.at("battery"),
          {"capacity_mAh", "voltage_V", "internal_resistance_ohm", "rate_exponent", "capacity_per_C"},
          where + ", battery");
      !known)
    return in_file(known.error());
  if (!object.contains("kernel")) return reader.missing("kernel", where);
  if (const auto known = refuse_unknown_keys(object.at("kernel"),
                                             {"bandwidth_GB_s", "peak_GFLOPS", "fast_memory_MB", "fast_bandwidth_GB_s",
                                              "launch_us", "tile_nodes", "active_W", "energy_nJ_per_byte", "measured"},
                                             where + ", kernel");
      !known)
    return in_file(known.error());
  return {};
}

Result<Worn> read_worn(const Json& object, const std::string& where, const FigureReader& reader) {
  const auto name = reader.text(object, "worn", where);
  if (!name) return failure(name.error());
  for (const Worn worn : {Worn::head, Worn::belt, Worn::back}) {
    if (*name == to_string(worn)) return worn;
  }
  return failure(Error{"worn-unknown",
                       GLISSON_TEXT("{0} is worn \"{1}\"."),
                       {where, *name},
                       GLISSON_TEXT("Use head, belt or back."),
                       reader.file()});
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
