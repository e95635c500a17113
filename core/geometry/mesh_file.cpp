// The one file that speaks to VTK's readers and writers.
#include "geometry/mesh_file.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPLYWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <algorithm>
#include <exception>
#include <string>

#include "base/files.h"
#include "base/write_file.h"
#include "geometry/internal/legacy_vtk_guard.h"
#include "geometry/internal/mesh_file_guard.h"
#include "geometry/internal/obj_file.h"
#include "geometry/internal/off_file.h"
#include "geometry/internal/vtk_values.h"
#include "geometry/internal/xml_guard.h"
#include "geometry/ply_file.h"
#include "geometry/triangles_file.h"

namespace glisson::geometry {
namespace {

namespace fs = std::filesystem;

Failure format_unknown(const fs::path& file, const std::string& known);

// Opens the file with one of VTK's readers; the reader's own complaints become the Error.
template <typename Reader, typename Data>
Result<vtkSmartPointer<Data>> read_with(const fs::path& file);

// Writes it with one of VTK's writers. `configure` sets what is particular to the format.
template <typename Writer, typename Configure>
Result<void> write_with(const fs::path& file, vtkDataObject* data, Configure&& configure);

}  // namespace

Result<Surface> read_surface(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".obj" || extension == ".off" || extension == ".ply") {
    auto surface = extension == ".obj" ? read_obj(file) : extension == ".off" ? read_off(file) : read_ply(file);
    if (!surface) return surface;
    if (auto checked = check_surface(*surface); !checked) return failure(std::move(checked.error()).in_file(file));
    return surface;
  }
  Result<vtkSmartPointer<vtkPolyData>> polygons;
  if (extension == ".vtp") {
    polygons = read_with<vtkXMLPolyDataReader, vtkPolyData>(file);
  } else if (extension == ".vtk") {
    polygons = read_with<vtkPolyDataReader, vtkPolyData>(file);
  } else if (extension == ".stl") {
    polygons = read_with<vtkSTLReader, vtkPolyData>(file);
  } else {
    return format_unknown(file, ".vtp, .vtk, .stl, .obj, .off, .ply");
  }
  if (!polygons) return failure(polygons.error());
  return surface_from(*polygons, file);
}

Result<Surface> read_triangles(const fs::path& file) {
  if (file.extension() != ".vtu") return read_surface(file);
  const auto grid = read_with<vtkXMLUnstructuredGridReader, vtkUnstructuredGrid>(file);
  if (!grid) return failure(grid.error());
  return triangles_from(*grid, file);
}

Result<void> write_surface(const fs::path& file, const Surface& surface) {
  if (auto checked = check_surface(surface); !checked) return checked;
  const std::string extension = file.extension().string();
  if (extension == ".obj") return write_obj(file, surface);
  const auto polygons = polygons_from(surface);
  if (extension == ".vtp")
    return write_with<vtkXMLPolyDataWriter>(file, polygons, [](auto& writer) {
      writer.SetDataModeToAppended();
      writer.EncodeAppendedDataOff();
    });
  if (extension == ".stl") return write_with<vtkSTLWriter>(file, polygons, [](auto& w) { w.SetFileTypeToBinary(); });
  if (extension == ".ply") return write_with<vtkPLYWriter>(file, polygons, [](auto& w) { w.SetFileTypeToBinary(); });
  return format_unknown(file, ".vtp, .stl, .obj, .ply");
}

Result<TetMesh> read_tetrahedra(const fs::path& file) {
  const std::string extension = file.extension().string();
  Result<vtkSmartPointer<vtkUnstructuredGrid>> grid;
  if (extension == ".vtu") {
    grid = read_with<vtkXMLUnstructuredGridReader, vtkUnstructuredGrid>(file);
  } else if (extension == ".vtk") {
    grid = read_with<vtkUnstructuredGridReader, vtkUnstructuredGrid>(file);
  } else {
    return format_unknown(file, ".vtu, .vtk");
  }
  if (!grid) return failure(grid.error());
  return tetrahedra_from(*grid, file);
}

Result<void> write_tetrahedra(const fs::path& file, const TetMesh& mesh) {
  if (file.extension() != ".vtu") return format_unknown(file, ".vtu");
  return write_with<vtkXMLUnstructuredGridWriter>(file, grid_from(mesh), [](auto& writer) {
    writer.SetDataModeToAppended();
    writer.EncodeAppendedDataOff();
  });
}

namespace {

Failure format_unknown(const fs::path& file, const std::string& known) {
  return failure(Error{"mesh-format-unknown",
                       GLISSON_TEXT("{0} has no extension that is known for such a mesh."),
                       {file.filename().string(), known},
                       GLISSON_TEXT("Known are: {1}"),
                       file});
}

// Keeps the first complaint of a VTK object, which would otherwise go to stderr.
class FirstComplaint : public vtkCommand {
 public:
  static FirstComplaint* New() { return new FirstComplaint; }
  void Execute(vtkObject*, unsigned long, void* text) override {
    if (!text_.empty() || text == nullptr) return;
    text_ = static_cast<const char*>(text);
    // VTK writes "ERROR: In /its/source.cxx, line 1\nvtkReader (0x..): what is wrong\n\n".
    if (const std::size_t named = text_.find("): "); named != std::string::npos) text_.erase(0, named + 3);
    std::replace(text_.begin(), text_.end(), '\n', ' ');
    while (!text_.empty() && (text_.back() == ' ' || text_.back() == '.')) text_.pop_back();
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Takes what VTK says without an observer to hear it (of decompression that failed, of text that is no number) on the
// thread that listens; elsewhere VTK speaks as before.
class Listener : public vtkOutputWindow {
 public:
  static Listener* New() { return new Listener; }
  void DisplayErrorText(const char* text) override {
    if (!heard(text)) vtkOutputWindow::DisplayErrorText(text);
  }
  void DisplayGenericWarningText(const char* text) override {
    const bool of_reading = std::string_view(text).find("Error reading") != std::string_view::npos;
    if (!of_reading || !heard(text)) vtkOutputWindow::DisplayGenericWarningText(text);
  }

  // Hears for as long as it stands.
  class Ear {
   public:
    explicit Ear(FirstComplaint& complaint) {
      static const bool installed = [] {
        const vtkNew<Listener> listener;
        vtkOutputWindow::SetInstance(listener);
        return true;
      }();
      static_cast<void>(installed);
      hearing = &complaint;
    }
    ~Ear() { hearing = nullptr; }
    Ear(const Ear&) = delete;
    Ear& operator=(const Ear&) = delete;
  };

 private:
  static bool heard(const char* text) {
    if (hearing != nullptr) hearing->Execute(nullptr, vtkCommand::ErrorEvent, const_cast<char*>(text));
    return hearing != nullptr;
  }
  static thread_local FirstComplaint* hearing;
};
thread_local FirstComplaint* Listener::hearing = nullptr;

template <typename Reader, typename Data>
Result<vtkSmartPointer<Data>> read_with(const fs::path& file) {
  if (auto checked = check_announced_counts(file); !checked) return failure(checked.error());
  if constexpr (std::is_base_of_v<vtkDataReader, Reader>) {
    if (auto checked = check_cell_lists(file); !checked) return failure(checked.error());
  }
  if constexpr (std::is_base_of_v<vtkXMLReader, Reader>) {
    if (auto checked = check_xml_elements(file); !checked) return failure(checked.error());
  }
  const vtkNew<FirstComplaint> complaint;
  const Listener::Ear ear(*complaint);
  try {
    const vtkNew<Reader> reader;
    reader->AddObserver(vtkCommand::ErrorEvent, complaint);
    reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, complaint);
    if constexpr (std::is_base_of_v<vtkXMLReader, Reader>) {
      reader->SetReaderErrorObserver(complaint);
      reader->SetParserErrorObserver(complaint);
    } else if constexpr (std::is_base_of_v<vtkDataReader, Reader>) {
      reader->ReadAllScalarsOn();
      reader->ReadAllVectorsOn();
      reader->ReadAllNormalsOn();
      reader->ReadAllTensorsOn();
      reader->ReadAllFieldsOn();
    }
    reader->SetFileName(file.c_str());
    reader->Update();
    if (!complaint->text().empty()) return mesh_file_invalid(file, complaint->text());
    vtkSmartPointer<Data> data = Data::SafeDownCast(reader->GetOutput());
    if (!data || data->GetNumberOfPoints() == 0) return mesh_file_invalid(file, GLISSON_TEXT("it holds no points"));
    return data;
  } catch (const std::exception& thrown) {
    return mesh_file_invalid(file, thrown.what());
  }
}

template <typename Writer, typename Configure>
Result<void> write_with(const fs::path& file, vtkDataObject* data, Configure&& configure) {
  return write_atomically(file, [&](const fs::path& beside) -> Result<void> {
    const vtkNew<FirstComplaint> complaint;
    const vtkNew<Writer> writer;
    writer->AddObserver(vtkCommand::ErrorEvent, complaint);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, complaint);
    configure(*writer);
    writer->SetInputData(data);
    writer->SetFileName(beside.c_str());
    if (writer->Write() != 0 && complaint->text().empty()) return {};
    return file_not_writable(file, complaint->text());
  });
}

}  // namespace
}  // namespace glisson::geometry
