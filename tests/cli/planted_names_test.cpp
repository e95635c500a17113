// A hundred names, numbers and notes are planted wherever a study has room for them. They stand in the attributes of
// its files, outermost and nested, and in private ones. They stand in the names of files and folders, and in the
// comments of volumes, labels and surfaces. Then everything that the program writes is searched for them.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <zlib.h>
#include <algorithm>
#include <cctype>

#include "base/files.h"
#include "base/json.h"
#include "support/data.h"
#include "support/dicom_files.h"
#include "support/process.h"
#include "support/small_liver.h"
#include "support/stereo_video.h"

namespace glisson::test {
namespace {

namespace fs = std::filesystem;

const std::string planted = "SEKRET";
const std::string planted_uid = "1.2.826.0.987654321";
// A day and a time of birth or of anything else, an age, and what a scale said.
const std::string planted_date = "19470813", planted_time = "134759.1357", planted_age = "079Y";
const std::string planted_size_m = "1.7654321", planted_weight_kg = "67.812345";
const std::vector<std::string> secrets{planted,     planted_uid,    planted_date,     planted_time,
                                       planted_age, planted_size_m, planted_weight_kg};

// What an attribute of that kind could tell; empty where the dictionary gives it another kind.
std::string telling(const DcmTag& tag) {
  if (tag == DCM_PatientSize) return planted_size_m;
  if (tag == DCM_PatientWeight) return planted_weight_kg;
  switch (tag.getEVR()) {
    case EVR_PN:
    case EVR_LO:
    case EVR_SH:
    case EVR_LT:
    case EVR_ST:
    case EVR_UT:
    case EVR_UC:
    case EVR_AE:
    case EVR_CS: return fmt::format("{}{:04x}", planted, tag.getElement());
    case EVR_DA: return planted_date;
    case EVR_TM: return planted_time;
    case EVR_DT: return planted_date + planted_time;
    case EVR_AS: return planted_age;
    default: return {};
  }
}

// All that a file of the dictionary may hold, and the same two levels down; terms by which a picture is read stay.
int plant_everywhere(DcmDataset& data) {
  DcmItem *frame = nullptr, *deep = nullptr;
  data.findOrCreateSequenceItem(DCM_ReferencedImageSequence, frame, -2);
  frame->findOrCreateSequenceItem(DCM_PurposeOfReferenceCodeSequence, deep, -2);
  std::vector<DcmTag> tags;
  DcmDataDictionary& dictionary = dcmDataDict.wrlock();
  for (auto entry = dictionary.normalBegin(); entry != dictionary.normalEnd(); ++entry) {
    const DcmTagKey key = (*entry)->getKey();
    const bool of_the_file = key.getGroup() < 0x0008 || key.getGroup() >= 0x7fe0 || key.getElement() == 0;
    if (of_the_file || (*entry)->getPrivateCreator() != nullptr) continue;
    tags.emplace_back(key, (*entry)->getVR());
  }
  dcmDataDict.wrunlock();
  int count = 0;
  for (const DcmTag& tag : tags) {
    const std::string text = telling(tag);
    if (text.empty()) continue;
    for (DcmItem* item : {static_cast<DcmItem*>(&data), deep}) {
      if (tag.getEVR() == EVR_CS && item->tagExists(tag)) continue;
      if (item->putAndInsertString(tag, text.c_str()).good()) ++count;
    }
  }
  data.putAndInsertString(DcmTag(0x0009, 0x0010, EVR_LO), planted.c_str());
  data.putAndInsertString(DcmTag(0x0009, 0x1001, EVR_UT), planted.c_str());
  return count;
}

// The small liver as a study.
int write_study(const fs::path& folder) {
  int count = 0;
  for (int k = 0; k < 26; ++k) {
    SliceSpec spec;
    spec.columns = 34;
    spec.rows = 26;
    spec.column_spacing_mm = spec.row_spacing_mm = 5;
    spec.position_mm = {-82.5, -62.5, -62.5 + 5.0 * k};
    spec.instance_number = k + 1;
    spec.study_uid = planted_uid + ".1";
    spec.series_uid = planted_uid + ".2";
    spec.frame_of_reference_uid = planted_uid + ".3";
    spec.value = [=](int i, int j) {
      const double x = -82.5 + 5 * i, y = -62.5 + 5 * j, z = -62.5 + 5 * k;
      return x * x / 4900 + y * y / 2500 + z * z / 2500 < 1 ? 300 : 40;
    };
    const auto file = dicom_slice(spec);
    count += plant_everywhere(*file->getDataset());
    file->getDataset()->putAndInsertString(DCM_SOPInstanceUID, fmt::format("{}.4.{}", planted_uid, k).c_str());
    fs::create_directories(folder);
    save(*file, folder / fmt::format("{}-{:02}.dcm", planted, k));
  }
  return count;
}

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

// What a file holds, unpacked where it is packed as a whole.
std::string content(const fs::path& file) {
  if (file.extension() != ".gz") return *read_text_file(file);
  std::string bytes;
  const gzFile stream = ::gzopen(file.c_str(), "rb");
  char block[4096];
  for (int got = 0; (got = ::gzread(stream, block, sizeof block)) > 0;)
    bytes.append(block, static_cast<std::size_t>(got));
  ::gzclose(stream);
  return bytes;
}

// Where a secret stands, or npos. An age comes up by chance in a packed picture, a date in a long number's digits: they
// count where they stand by themselves.
std::size_t place_of(const std::string& secret, const std::string& bytes) {
  const auto within_a_word = [&](std::size_t at) {
    return at < bytes.size() &&
           (std::isalnum(static_cast<unsigned char>(bytes[at])) || std::string("+/.").find(bytes[at]) < 3);
  };
  std::size_t at = bytes.find(secret);
  if (secret != planted_age && secret != planted_date) return at;
  while (at != std::string::npos && (within_a_word(at - 1) || within_a_word(at + secret.size())))
    at = bytes.find(secret, at + 1);
  return at;
}

int expect_nothing_planted_in(const fs::path& folder) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().string().substr(folder.string().size());
    EXPECT_EQ(in_capitals(name).find(planted), std::string::npos) << name;
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::string bytes = in_capitals(content(entry.path()));
    for (const std::string& secret : secrets) {
      const std::size_t at = place_of(secret, bytes);
      EXPECT_EQ(at, std::string::npos) << name << ": ..." << bytes.substr(at < 60 ? 0 : at - 60, 160) << "...";
    }
  }
  return files;
}

class PlantedNames : public testing::Test {
 protected:
  // What it answers is searched too, but for the names that the person gave it.
  void run(std::vector<std::string> words) {
    std::vector<std::string> given = words;
    // The longest first: a "3" taken away from a folder's name would leave the rest of it.
    std::sort(given.begin(), given.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    words.insert(words.end(), {"--json", "--quiet"});
    const Finished finished = glisson_cli(words);
    EXPECT_EQ(finished.exit_code, 0) << words.front() << ": " << finished.err;
    std::string said = finished.out + finished.err;
    for (const std::string& word : given) {
      for (std::size_t at = said.find(word); at != std::string::npos; at = said.find(word)) said.erase(at, word.size());
    }
    EXPECT_TRUE(write_text_file(out(fmt::format("answers/{:02}-{}.json", ++answers_, words.front())), said));
  }
  [[nodiscard]] std::string in(const std::string& name) const { return (disc_.path() / name).string(); }
  [[nodiscard]] std::string out(const std::string& name) const { return (out_.path() / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_text_file(disc_.path() / name, text));
  }

  TemporaryFolder disc_, out_;
  int answers_ = 0;
};

TEST_F(PlantedNames, StandInNothingThatIsWritten) {
  const std::string study = in("SEKRET-Anna/scan");
  EXPECT_GT(write_study(study), 26 * 100);
  ASSERT_TRUE(write_small_liver(disc_.path()));
  fs::rename(in("liver.nrrd"), in("SEKRET-liver.nrrd"));
  fs::rename(in("tumour.nrrd"), in("SEKRET-tumour.nrrd"));
  // Free text in a volume's header.
  std::string noted = *read_text_file(in("scan.nrrd"));
  noted.insert(noted.find('\n') + 1, "# SEKRET comment\ncontent: SEKRET\nSekretKey:=SEKRET\n");
  write("SEKRET.nrrd", noted);
  write("pull.json", R"({"loads": [{"tool": {"center_mm": [0, -50, 0], "radius_mm": 15, "force_N": [0, -0.5, 0]}}]})");
  write("hook.json", R"({"format": "glisson-session/1", "commands": [{"hold": {"id": "hook",
      "shape": "nathanson-retractor", "position_mm": [0, 0, -70], "direction": [0, 0, 1], "push_mN": 200}}]})");
  write("right.json", R"({"name": "right", "plane": {"point_mm": [-10, 0, 0], "normal": [1, 0, 0]}})");
  write("SEKRET-model.json", R"({"format": "glisson-closedloop-model/1", "kind": "palpation", "verdict": "explained",
      "effects": [{"kind": "stiffness-scale", "parameters": {"factor": 0.5}}]})");

  const std::string patient = out("p.glisson");
  run({"import", study, "--case", patient});
  run({"import", in("SEKRET.nrrd"), "--case", out("q.glisson")});
  run({"segment", patient, "--structure", "liver", "--labels", in("SEKRET-liver.nrrd")});
  run({"segment", patient, "--structure", "tumour-1", "--labels", in("SEKRET-tumour.nrrd")});
  run({"mesh", patient, "--target-cells", "600"});
  run({"stiffness", patient, "--uniform-kPa", "6"});
  run({"simulate", patient, "--scenario", in("pull.json"), "--out", out("result")});
  run({"resect", patient, "--plane=-20,0,0,1,0,0", "--out", out("resection")});
  run({"session", patient, "--commands", in("hook.json"), "--out", out("recorded.json")});
  run({"accept", patient, in("SEKRET-model.json"), "--of-this-patient"});
  run({"report", patient, "--out", out("page.html")});
  run({"render", patient, "--scene", "liver", "--size", "160x120", "--out", out("organ.png")});
  for (const char* format : {"nrrd", "nifti", "stl", "obj", "vtp"}) {
    run({"export", patient, "--format", format, "--out", out(format)});
  }
  run({"export", patient, "--format", "dicom-seg", "--out", out("seg.dcm")});
  run({"export", patient, "--format", "vtu", "--out", out("liver.vtu")});
  run({"plan", patient, "--add", in("right.json")});
  run({"plan", patient, "--compare", "--out", out("plans")});
  run({"macro", patient, "--as", "python"});
  run({"study", "example-sequence", "--frames", "3", "--out", in("SEKRET-video")});
  run({"guide", patient, "--sequence", in("SEKRET-video/sequence.json"), "--pose=1,0,0,0,0,1,0,0,0,0,1,150,0,0,0,1",
       "--out", out("placed")});
  run({"deidentify", in("SEKRET-Anna"), "--out", out("nameless")});
  run({"import", out("nameless"), "--case", out("r.glisson")});
  // Surfaces with a title in them.
  std::string obj = *read_text_file(out("obj/liver.obj"));
  write("SEKRET.obj", "# SEKRET\no SEKRET\n" + obj);
  run({"register", in("SEKRET.obj"), in("SEKRET.obj"), "--method", "icp", "--out", out("moved.ply")});
  run({"match", in("SEKRET.obj"), in("SEKRET.obj"), "--points", "20", "--out", out("matches.csv")});
  ASSERT_FALSE(HasFailure());
  EXPECT_GT(expect_nothing_planted_in(out_.path()), 40);

  // On request alone: so that an archive can put the outlines to the images.
  run({"export", patient, "--format", "dicom-seg", "--study", study, "--out", out("referring.dcm")});
  DcmFileFormat referring;
  ASSERT_TRUE(referring.loadFile(out("referring.dcm").c_str()).good());
  OFString name, study_uid;
  referring.getDataset()->findAndGetOFString(DCM_PatientName, name);
  referring.getDataset()->findAndGetOFString(DCM_StudyInstanceUID, study_uid);
  EXPECT_THAT(name.c_str(), testing::HasSubstr(planted));
  EXPECT_EQ(study_uid, OFString((planted_uid + ".1").c_str()));
  DcmItem* series = nullptr;
  ASSERT_TRUE(referring.getDataset()->findAndGetSequenceItem(DCM_ReferencedSeriesSequence, series).good());
  DcmSequenceOfItems* instances = nullptr;
  ASSERT_TRUE(series->findAndGetSequence(DCM_ReferencedInstanceSequence, instances).good());
  EXPECT_EQ(instances->card(), 26u);
  const Finished other = glisson_cli(
      {"export", patient, "--format", "dicom-seg", "--study", out("nameless"), "--out", out("no.dcm"), "--quiet"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, testing::HasSubstr("does not hold the images"));
}

// By these words elastography is recognised: what is planted there stands behind them.
int plant_among_words(DcmDataset& data) {
  std::vector<std::pair<DcmTagKey, std::string>> words;
  for (const DcmTagKey& key : {DCM_SeriesDescription, DCM_ProtocolName, DCM_SequenceName, DCM_ImageComments}) {
    OFString text;
    if (data.findAndGetOFString(key, text).good()) words.emplace_back(key, text.c_str());
  }
  const int count = plant_everywhere(data);
  for (const auto& [key, text] : words) data.putAndInsertString(key, (text + " " + planted).c_str());
  return count;
}

// A measured brain's phase images, planted in every file.
TEST_F(PlantedNames, StandInNothingThatIsMadeOfWaves) {
  GLISSON_NEEDS_DATA("mre_brain_ir_charite");
  int files = 0;
  std::vector<std::string> uids;
  for (const char* series : {"series_045_mre_noInv_mag", "series_046_mre_noInv_phase"}) {
    fs::create_directories(disc_.path() / "SEKRET-Anna" / series);
    for (const auto& entry : fs::directory_iterator(shared_data() / "mre_brain_ir_charite/volunteer_A" / series)) {
      DcmFileFormat file;
      if (!entry.is_regular_file() || file.loadFile(entry.path().c_str()).bad()) continue;
      EXPECT_GT(plant_among_words(*file.getDataset()), 100);
      save(file, disc_.path() / "SEKRET-Anna" / series / fmt::format("SEKRET-{:03}.dcm", files++));
    }
  }
  ASSERT_GT(files, 2);
  const Finished scan = glisson_cli({"scan", in("SEKRET-Anna"), "--json", "--quiet"});
  const Json found = scan.json();
  for (const Json& series : found.at("series")) uids.push_back(series.at("uid"));
  ASSERT_EQ(uids.size(), 2u) << scan.out << scan.err;

  const std::string brain = out("brain.glisson");
  run({"import", in("SEKRET-Anna"), "--case", brain, "--magnitude", uids[0], "--phase", uids[1]});
  run({"invert", brain, "--frequency-Hz", "20"});
  for (const char* scene : {"waves", "stiffness", "confidence"}) {
    run({"render", brain, "--scene", scene, "--size", "160x120", "--out", out(scene + std::string(".png"))});
  }
  run({"export", brain, "--format", "nrrd", "--out", out("nrrd")});
  EXPECT_GT(expect_nothing_planted_in(out_.path()), 20);
}

TEST_F(PlantedNames, StandInNothingThatComparesTwoStudies) {
  write_study(disc_.path() / "SEKRET-Anna/before");
  write_study(disc_.path() / "SEKRET-Anna/after");
  ASSERT_TRUE(write_small_liver(disc_.path()));
  write("right.json", R"({"name": "right", "segments": [5, 6, 7, 8]})");
  for (const std::string study : {"before", "after"}) {
    const std::string patient = out(study + ".glisson");
    run({"import", in("SEKRET-Anna/" + study), "--case", patient});
    run({"segment", patient, "--structure", "liver", "--labels", in("liver.nrrd")});
    run({"territories", patient, "--from", "prior", "--couinaud"});
  }
  run({"plan", out("before.glisson"), "--add", in("right.json")});
  run({"growth", out("before.glisson"), out("after.glisson"), "--plan", "right", "--out", out("growth")});
  EXPECT_GT(expect_nothing_planted_in(out_.path()), 10);
}

// A picture with a comment in it, as cameras and editors write them (a PNG's tEXt chunk behind its header).
void note_in_png(const fs::path& file) {
  std::string bytes = *read_text_file(file);
  const std::string chunk = std::string("tEXtAuthor") + '\0' + planted;
  const auto four = [](std::uint32_t value) {
    return std::string{static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
                       static_cast<char>(value)};
  };
  const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(chunk.data()), static_cast<uInt>(chunk.size()));
  bytes.insert(33, four(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk + four(static_cast<std::uint32_t>(sum)));
  ASSERT_TRUE(write_text_file(file, bytes));
}

TEST_F(PlantedNames, StandInNothingThatIsMadeOfAVideo) {
  GLISSON_NEEDS_DATA("hamlyn_heart_stereo");
  const StereoVideo video(
      vision::read_frame(shared_data() / "hamlyn_heart_stereo/f7_dynamic_deint_L_0100.png").value());
  for (const char* eye : {"SEKRET-left", "SEKRET-right"}) fs::create_directories(disc_.path() / eye);
  for (int t = 0; t < 6; ++t) {
    const std::string name = fmt::format("SEKRET-{}.png", t);
    ASSERT_TRUE(vision::write_frame(video.left(2 * t), disc_.path() / "SEKRET-left" / name));
    ASSERT_TRUE(vision::write_frame(video.right(2 * t), disc_.path() / "SEKRET-right" / name));
    note_in_png(disc_.path() / "SEKRET-left" / name);
    note_in_png(disc_.path() / "SEKRET-right" / name);
  }
  ASSERT_TRUE(vision::write_stereo_calibration(disc_.path() / "SEKRET-camera.json", StereoVideo::calibration()));
  Json camera = *parse_json(*read_text_file(disc_.path() / "SEKRET-camera.json"));
  camera["hospital"] = planted;
  write("SEKRET-camera.json", camera.dump());

  run({"stereo", in("SEKRET-left/SEKRET-0.png"), in("SEKRET-right/SEKRET-0.png"), "--calibration",
       in("SEKRET-camera.json"), "--out", out("cloud.ply"), "--picture", out("depth.png")});
  run({"sequence", in("SEKRET-left"), in("SEKRET-right"), "--calibration", in("SEKRET-camera.json"), "--step", "8",
       "--out", out("sequence")});
  for (const std::string method : {"icp", "gnra"}) {
    run({"sirgn", out("sequence/sequence.json"), "--method", method, "--pictures", "--out", out(method)});
  }
  run({"review", out("icp"), out("gnra"), "--out", out("review")});
  EXPECT_GT(expect_nothing_planted_in(out_.path()), 20);
}

}  // namespace
}  // namespace glisson::test
