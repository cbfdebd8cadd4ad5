// Inputs that are broken in one way each: every one gives a sentence that names what is wrong, exit code 1 and no output.
#include "tests/support/broken_inputs.hpp"

#include <unistd.h>

namespace quell::tests::broken {

TEST_CASE("broken images of separate files are named", "[broken]") {
  check("separate", writeSeparate,
        {{"colour cut in half", [](const Input& i) { i.cut("color_0001.exr", 0.5); }, {"color_0001.exr"}},
         {"colour cut in its header",
          [](const Input& i) { i.cut("color_0001.exr", 0.05); },
          {"color_0001.exr"}},
         {"colour lacks the last byte",
          [](const Input& i) { i.cut("color_0001.exr", 0.999); },
          {"color_0001.exr"}},
         {"colour empty", [](const Input& i) { i.write("color_0001.exr", ""); }, {"color_0001.exr"}},
         {"colour a text", [](const Input& i) { i.write("color_0001.exr", "hello"); }, {"color_0001.exr"}},
         {"colour a PNG",
          [](const Input& i) { i.write("color_0001.exr", "\x89PNG\r\n\x1a\n"); },
          {"color_0001.exr"}},
         {"normals cut",
          [](const Input& i) { i.cut("shading_normal_0001.exr", 0.6); },
          {"shading_normal_0001.exr"}},
         {"positions empty",
          [](const Input& i) { i.write("world_position_0001.exr", ""); },
          {"world_position_0001.exr"}},
         {"positions missing",
          [](const Input& i) { i.remove("world_position_0002.exr"); },
          {"world_position_0002.exr"}},
         {"albedo of half the frames",
          [](const Input& i) { i.remove("albedo_0002.exr"); },
          {"albedo_0002.exr"}},
         {"no normals at all",
          [](const Input& i) {
            i.remove("shading_normal_0001.exr");
            i.remove("shading_normal_0002.exr");
          },
          {"shading_normal_0001.exr"}}});
}

TEST_CASE("separate files of other channels and sizes are named", "[broken]") {
  check("separate", writeSeparate,
        {{"normals of another size",
          [](const Input& i) {
            i.image("shading_normal_0001.exr", {"R", "G", "B"}, 5);
          },
          {"shading_normal_0001.exr"}},
         {"albedo of another size",
          [](const Input& i) {
            i.image("albedo_0001.exr", {"R", "G", "B"}, 7);
          },
          {"albedo_0001.exr"}},
         {"colour without green",
          [](const Input& i) {
            i.image("color_0001.exr", {"B", "R"});
          },
          {"color_0001.exr", "B R"}},
         {"normals of channels U V W",
          [](const Input& i) {
            i.image("shading_normal_0001.exr", {"U", "V", "W"});
          },
          {"shading_normal_0001.exr", "U V W"}},
         {"positions of one channel",
          [](const Input& i) { i.image("world_position_0001.exr", {"Y"}); },
          {"world_position_0001.exr"}},
         {"normals a folder",
          [](const Input& i) { i.asFolder("shading_normal_0001.exr"); },
          {"shading_normal_0001.exr"}}});
}

TEST_CASE("what is wrong with later frames and references is told before anything is written", "[broken]") {
  check("separate", writeSeparate,
        {{"the last frame of another size",
          [](const Input& i) {
            i.image("color_0002.exr", {"R", "G", "B"}, 7);
          },
          {"color_0002.exr", "6x4", "7x4"}},
         {"the last frame cut in half",
          [](const Input& i) { i.cut("color_0002.exr", 0.5); },
          {"color_0002.exr"}},
         {"a reference cut in half",
          [](const Input& i) {
            i.image("ref_a_color_0002.exr", {"R", "G", "B"});
            i.cut("ref_a_color_0002.exr", 0.6);
          },
          {"ref_a_color_0002.exr"}},
         {"a reference of another size",
          [](const Input& i) {
            i.image("ref_b_color_0002.exr", {"R", "G", "B"}, 5);
          },
          {"ref_b_color_0002.exr", "6x4", "5x4"}},
         {"the last normals of other channels",
          [](const Input& i) {
            i.image("shading_normal_0002.exr", {"U", "V", "W"});
          },
          {"shading_normal_0002.exr", "U V W"}}});
}

TEST_CASE("frames, devices and settings that are not there are named", "[broken]") {
  const auto nothing = [](const Input&) {};
  check("separate", writeSeparate,
        {{"a frame missing",
          [](const Input& i) {
            i.image("color_0004.exr", {"R", "G", "B"});
          },
          {"color_0003.exr", "--missing"}},
         {"a number twice",
          [](const Input& i) {
            i.image("color_1.exr", {"R", "G", "B"});
          },
          {"color_1.exr", "color_0001.exr"}},
         {"no frames",
          [](const Input& i) {
            i.remove("color_0001.exr");
            i.remove("color_0002.exr");
          },
          {"in"}},
         {"two signals without files", nothing, {"diffuse_irradiance"}, {"--signals", "2"}},
         {"frames that are not there", nothing, {"--frames", "1-2"}, {"--frames", "7-9"}},
         {"a device that is not there", nothing, {"no such device"}, {"--device", "no such device"}},
         {"a setting that is not there", nothing, {"colour"}, {"--set", "colour=3"}}});
}

TEST_CASE("broken cameras are named", "[broken]") {
  const auto text = [](const std::string& whole) {
    return [whole](const Input& i) { i.write("camera.json", whole); };
  };
  const auto entry = [](const std::string& one) { return [one](const Input& i) { i.camera(one); }; };
  check("camera.json", writeSeparate,
        {{"missing", [](const Input& i) { i.remove("camera.json"); }, {"camera.json"}},
         {"empty", text(""), {"camera.json"}},
         {"cut", [](const Input& i) { i.cut("camera.json", 0.7); }, {"camera.json", "parse error"}},
         {"a folder", [](const Input& i) { i.asFolder("camera.json"); }, {"camera.json"}},
         {"bytes", text(std::string("\0\xff\xfe{", 4)), {"camera.json"}},
         {"a list", text("[1, 2]"), {"camera.json", "frames"}},
         {"frames null", text("{\"frames\": null}"), {"frames", "null"}},
         {"frames empty", text("{\"frames\": []}"), {"frame 1"}},
         {"not a number", text("{\"frames\": [{\"frame\": NaN}]}"), {"parse error"}},
         {"lists in lists in lists", text(std::string(100000, '[')), {"parse error"}},
         {"frame a text", text("{\"frames\": [{\"frame\": \"1\"}]}"), {"frames[0].frame"}},
         {"no camera", text("{\"frames\": [{\"frame\": 1}]}"), {"frames[0]", "view_projection"}},
         {"3 rows", entry("\"view_projection\": [[1,2,3,4],[1,2,3,4],[1,2,3,4]]"), {"4 rows"}},
         {"15 numbers", entry("\"view_projection\": [1,2,3,4,5,6,7,8,9,10,11,12,13,14,15]"), {"4 rows"}},
         {"texts in the matrix",
          entry("\"view_projection\": [[1,2,3,4],[1,2,3,4],[1,2,3,4],[1,2,3,\"4\"]]"),
          {"view_projection[3][3]"}},
         {"view alone", entry(std::string("\"view\": ") + kMatrix), {"projection"}},
         {"eye alone", entry("\"eye\": [1, 2, 3]"), {"target"}},
         {"jitter of 7 pixels",
          entry(std::string("\"jitter_px\": [7, 0], \"view_projection\": ") + kMatrix),
          {"jitter_px", "frame 1"}}});
  check("camera_matrices.h", writeBmfr,
        {{"empty", [](const Input& i) { i.write("camera_matrices.h", ""); }, {"camera_matrices"}},
         {"no numbers",
          [](const Input& i) { i.write("camera_matrices.h", "float camera_matrices[] = {a, b};"); },
          {"camera_matrices.h"}},
         {"cut", [](const Input& i) { i.cut("camera_matrices.h", 0.6); }, {"camera_matrices.h"}},
         {"a frame below 0",
          [](const Input& i) {
            for (const char* b : {"color", "shading_normal", "world_position", "albedo"})
              i.image(std::string(b) + "_.exr", {"R"});
            i.remove("color0.exr");
            i.remove("color1.exr");
          },
          {"color"}},
         {"two signals", [](const Input&) {}, {"two signals"}, {"--signals", "2"}}});
}

TEST_CASE("broken multilayer files are named", "[broken]") {
  const auto only = [](const std::string& without) {
    return [without](const Input& i) {
      for (const char* name : {"0001.exr", "0002.exr"}) i.multilayer(name, passesWithout(without));
    };
  };
  check("multilayer", writeMultilayer,
        {{"no normals", only("Normal"), {"ormal"}},
         {"no positions", only("Position"), {"osition"}},
         {"no colour", only("Combined"), {"in"}},
         {"first frame cut in its header", [](const Input& i) { i.cut("0001.exr", 0.02); }, {"0001.exr"}},
         {"first frame cut in half", [](const Input& i) { i.cut("0001.exr", 0.5); }, {"0001.exr"}},
         {"first frame empty", [](const Input& i) { i.write("0001.exr", ""); }, {"0001.exr"}},
         {"all frames empty",
          [](const Input& i) {
            i.write("0001.exr", "");
            i.write("0002.exr", "");
          },
          {"in"}},
         {"the last frame cut", [](const Input& i) { i.cut("0002.exr", 0.9); }, {"0002.exr"}},
         {"the last frame without a pass",
          [](const Input& i) { i.multilayer("0002.exr", passesWithout("Normal")); },
          {"0002.exr", "Normal.X"}},
         {"the last frame of another layer",
          [](const Input& i) { i.multilayer("0002.exr", somePasses(), "Other"); },
          {"0002.exr", "View Layer.Combined.R"}},
         {"two shots",
          [](const Input& i) { i.multilayer("b_0001.exr", somePasses()); },
          {"b_####.exr", "####.exr"}},
         {"two shots by a pattern",
          [](const Input& i) { i.multilayer("b_0001.exr", somePasses()); },
          {"b_####.exr"},
          {},
          "*.exr"},
         {"a frame missing",
          [](const Input& i) { i.multilayer("0005.exr", somePasses()); },
          {"0003.exr", "3 to 4"}},
         {"a pattern of nothing", [](const Input&) {}, {"c_####.exr"}, {}, "c_####.exr"},
         {"no such file", [](const Input&) {}, {"0007.exr"}, {}, "0007.exr"},
         {"a text as input",
          [](const Input& i) { i.write("notes.txt", "hello"); },
          {"notes.txt"},
          {},
          "notes.txt"},
         {"a camera.json of other frames",
          [](const Input& i) { i.write("camera.json", "{\"frames\": []}"); },
          {"camera.json", "frame 1"}}});
}

TEST_CASE("all commands that read sequences take channels, layers and gaps", "[broken]") {
  const TemporaryDirectory directory;
  const Input input{directory.file("in")};
  fs::create_directory(input.folder);
  writeMultilayer(input);
  const std::vector<std::vector<std::string>> commands = {{"denoise", "--input"},
                                                          {"bench", "--input"},
                                                          {"tune", "--vary", "iterations=4", "--input"},
                                                          {"select-features", "--input"},
                                                          {"check"}};
  for (std::vector<std::string> arguments : commands) {
    INFO(arguments.front());
    const int code = arguments.front() == "check" ? 2 : 1;
    arguments.insert(arguments.end(), {input.folder, "--missing", "skip", "--renderer", "cycles",
                                       "--channels", "albedo=Nowhere", "--layer", "No such layer"});
    CHECK_THAT(errorStreamOf(arguments, code, directory.file("stderr")),
               Catch::Contains("No such layer") && Catch::Contains("View Layer"));
  }
}

TEST_CASE("odd names of folders are no fault, and outputs that cannot be are named", "[broken]") {
  const TemporaryDirectory directory;
  for (const char* name :
       {"with space", "new\nline", "\xc3\xa9t\xc3\xa9", "percent %d #", "-leading", "quote's \"\""}) {
    INFO(name);
    const Input input{directory.file(name)};
    fs::create_directory(input.folder);
    writeSeparate(input);
    input.cut("world_position_0001.exr", 0.5);
    const std::string message =
        errorStreamOf({"denoise", "--input", input.folder}, 1, directory.file("stderr"));
    CHECK_THAT(message, Catch::Contains(input.file("world_position_0001.exr")));
  }
  const Input input{directory.file("with space")};
  writeSeparate(input);
  io::writeTextFile(directory.file("file"), "");
  for (const std::string& out :
       {directory.file("file"), directory.file("file") + "/out", std::string("/proc/out")}) {
    INFO(out);
    CHECK_THAT(
        errorStreamOf({"denoise", "--input", input.folder, "--output", out}, 1, directory.file("stderr")),
        Catch::Contains(out));
  }
  if (geteuid() == 0) return;  // to whom every folder is open
  fs::permissions(input.folder, fs::perms::none);
  CHECK_THAT(errorStreamOf({"denoise", "--input", input.folder}, 1, directory.file("stderr")),
             Catch::Contains("with space"));
  fs::permissions(input.folder, fs::perms::owner_all);
}

}  // namespace quell::tests::broken
