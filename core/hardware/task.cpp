#include "hardware/task.h"

#include <algorithm>
#include <set>

#include "hardware/device.h"
#include "hardware/internal/figure_file.h"

namespace glisson::hardware {
namespace {

constexpr const char* tasks_format = "glisson-tasks/1";
constexpr std::size_t maximum_tasks = 100;

Task task_from(const Json& object) {
  const std::string where = "A task";
  known_keys(object, {"id", "what", "bytes", "operations", "seconds", "source", "note"}, where);
  Task task;
  task.id = text_under(object, "id", where);
  task.what = text_under(object, "what", where);
  task.bytes = number_under(object, "bytes", {0, 1e18}, where);
  task.operations = number_under(object, "operations", {0, 1e18}, where);
  task.seconds = number_under(object, "seconds", {0, 1e6}, where);
  task.source = source_in(object, where);
  task.note = text_under(object, "note", where);
  if (task.bytes <= 0 && task.operations <= 0) {
    refuse("task-empty", GLISSON_TEXT("The task {0} moves no bytes and takes no operations."), {task.id});
  }
  return task;
}

std::vector<Task> tasks_from(const Json& document, const std::filesystem::path& file) {
  check_format(document, tasks_format, file);
  const auto list = document.find("tasks");
  if (list == document.end() || !list->is_array() || list->empty() || list->size() > maximum_tasks) {
    refuse("tasks-missing", GLISSON_TEXT("{0} has no list \"tasks\" of 1 to {1} tasks."),
           {file.string(), std::to_string(maximum_tasks)});
  }
  std::vector<Task> tasks;
  std::set<std::string> ids;
  for (const Json& object : *list) {
    tasks.push_back(task_from(object));
    if (!ids.insert(tasks.back().id).second) {
      refuse("task-twice", GLISSON_TEXT("Two tasks have the id \"{0}\"."), {tasks.back().id},
             GLISSON_TEXT("Give each its own."));
    }
  }
  return tasks;
}

}  // namespace

Result<std::vector<Task>> read_tasks(const std::filesystem::path& file) {
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  return reading("tasks-invalid", file, [&] { return tasks_from(*document, file); });
}

Result<void> write_tasks(const std::filesystem::path& file, const std::vector<Task>& tasks) {
  Json list = Json::array();
  for (const Task& task : tasks) {
    list.push_back({{"id", task.id},
                    {"what", task.what},
                    {"bytes", task.bytes},
                    {"operations", task.operations},
                    {"seconds", task.seconds},
                    {"source", to_string(task.source)},
                    {"note", task.note}});
  }
  return write_json_file(file, Json{{"format", tasks_format}, {"tasks", list}});
}

Workload workload_of(const Task& task) {
  constexpr double bytes_of_a_block = 60, operations_of_a_block = 18;  // a node of the dissertation's product
  Workload work;
  work.nodes = std::max({1.0, task.bytes / bytes_of_a_block, task.operations / operations_of_a_block});
  work.block_rows = work.block_columns = 0;
  work.products_per_frame = 1;
  work.bytes_per_node = task.bytes / work.nodes;
  work.product_bytes = work.frame_bytes = task.bytes;
  work.product_flops = work.frame_flops = task.operations;
  return work;
}

}  // namespace glisson::hardware
