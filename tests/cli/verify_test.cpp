#include <qpdf/qpdf-c.h>

#include <algorithm>
#include <fstream>

#include "tests/cli/project_command.h"

// Results that others file are verified from the report alone and the files it names.
namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* oneHouse = R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"height":40},"geometry":{"type":"Polygon","coordinates":
 [[[-73.98410,40.75300],[-73.98382,40.75300],[-73.98382,40.75321],[-73.98410,40.75321],[-73.98410,40.75300]]]}}]})";

class VerifyCommand : public testing::Test {
protected:
    void SetUp() override {
        std::ofstream(folder_.path("houses.geojson")) << oneHouse;
        const CommandOutput study = noonmarkCli(
            {"study", folder_.path("houses.geojson").string(), "--start", "2026-03-21", "--from", "09:00",
             "--hours", "6", "--step", "10", "--zone", "America/New_York", "--region",
             "-73.9845,40.7525,-73.9828,40.7536", "--cell", "2", "--out", folder_.path("out").string()});
        ASSERT_EQ(study.code, exitOk) << study.err;
    }

    [[nodiscard]] CommandOutput verify(const std::string& report) const {
        return noonmarkCli(
            {"verify", folder_.path(report).string(), "--inputs", folder_.path("").string(), "--json"});
    }

    void alter(const std::string& file, const std::string& from, const std::string& to) const {
        std::string text = readBytes(folder_.path(file));
        const auto at = text.find(from);
        ASSERT_NE(at, text.npos);
        text.replace(at, from.size(), to);
        std::ofstream(folder_.path(file), std::ios::binary) << text;
    }

    noonmark::tests::TemporaryFolder folder_;
};

TEST_F(VerifyCommand, AgreesWithAReportAndItsRecord) {
    for (const char* report : {"out/report.pdf", "out/study.json", "out"}) {
        const CommandOutput output = verify(report);
        EXPECT_EQ(output.code, exitOk) << output.err << output.out;
        const auto json = output.json();
        EXPECT_EQ(json["verdict"], "agrees");
        EXPECT_GT(json["figures"]["compared"], 50);
        EXPECT_EQ(json["inputs"][0]["agrees"], true);
    }
    EXPECT_GT(verify("out/report.pdf").json()["printed"]["figures"], 50);
}

// The report's folder lies in that of the city.
TEST_F(VerifyCommand, LooksAroundTheReportsFolderAndSaysWhereItLooked) {
    const std::string record = folder_.path("out/study.json").string();
    const CommandOutput found = noonmarkCli({"verify", record, "--json"});
    EXPECT_EQ(found.code, exitOk) << found.err << found.out;
    const std::string around = folder_.path("houses.geojson").parent_path().string();
    EXPECT_EQ(found.json()["looked_in"].size(), 2U);
    EXPECT_EQ(found.json()["looked_in"][1], around);
    EXPECT_EQ(found.json()["inputs"][0]["found"], folder_.path("houses.geojson").string());
    fs::create_directory(folder_.path("deeper"));
    fs::rename(folder_.path("houses.geojson"), folder_.path("deeper/houses.geojson"));
    const CommandOutput gone = noonmarkCli({"verify", record});
    EXPECT_EQ(gone.code, exitUsage) << "a neighbour of the report's folder is not searched";
    EXPECT_THAT(gone.out,
                HasSubstr("Looked in " + folder_.path("out").string() + " and its subfolders, " + around));
}

TEST_F(VerifyCommand, AgreesWithSunByPlace) {
    const CommandOutput places =
        noonmarkCli({"by-place", "sample:central-park-south", "--kind", "park", "--start", "2026-03-21",
                     "--from", "09:00", "--hours", "2", "--step", "20", "--zone", "America/New_York",
                     "--cell", "10", "--sheets", "--out", folder_.path("places").string()});
    ASSERT_EQ(places.code, exitOk) << places.err;
    for (const char* report : {"places/sheets.pdf", "places/places.json"}) {
        const CommandOutput output = verify(report);
        EXPECT_EQ(output.code, exitOk) << output.err << output.out;
        EXPECT_GT(output.json()["figures"]["compared"], 50);
        EXPECT_EQ(output.json()["tables"][0]["name"], "places.csv");
        EXPECT_EQ(output.json()["tables"][1]["name"], "places_by_time.csv");
    }
}

// The folder alone suffices: who gets it has the project, too.
TEST_F(VerifyCommand, FindsTheProjectThatWasPutBesideTheFiles) {
    const std::string project = folder_.path("town.noonmark.gpkg").string();
    const auto run = [](const std::vector<std::string>& words) {
        const CommandOutput output = noonmarkCli(words);
        ASSERT_EQ(output.code, exitOk) << output.err;
    };
    run({"project", "new", project, folder_.path("houses.geojson").string()});
    run({"project", "add-scenario", project, "Tower"});
    const std::vector<std::string> common{"--start",
                                          "2026-03-21",
                                          "--step",
                                          "10",
                                          "--zone",
                                          "America/New_York",
                                          "--with-project",
                                          "--cell",
                                          "2",
                                          "--region",
                                          "-73.9845,40.7525,-73.9828,40.7536"};
    const auto ask = [&](std::vector<std::string> words, const std::string& out) {
        words.insert(words.begin() + 1, project);
        words.insert(words.end(), common.begin(), common.end());
        words.insert(words.end(), {"--out", folder_.path(out).string()});
        run(words);
    };
    ask({"study", "--from", "09:00", "--hours", "6"}, "study");
    ask({"impact", "--to", "Tower", "--at", "09:00", "--hours", "6"}, "impact");
    ask({"score"}, "score");
    ask({"by-place"}, "places");
    fs::rename(project, folder_.path("elsewhere.gpkg"));
    for (const char* report : {"study/study.json", "impact/impact.json", "score/score.json"}) {
        const fs::path file = folder_.path(report);
        const CommandOutput output =
            noonmarkCli({"verify", file.string(), "--inputs", file.parent_path().string(), "--json"});
        EXPECT_EQ(output.code, exitOk) << report << output.err << output.out;
    }
    EXPECT_TRUE(fs::exists(folder_.path("places/town.noonmark.gpkg")));
    const CommandOutput none = noonmarkCli({"study", folder_.path("houses.geojson").string(), "--start",
                                            "2026-03-21", "--zone", "America/New_York", "--region", "city",
                                            "--with-project", "--out", folder_.path("none").string()});
    EXPECT_THAT(none.err, HasSubstr("no project to put beside"));
}

// Whatever else is saved in a project, a report stays true as long as what it rests on is the same.
TEST_F(VerifyCommand, AProjectWhosePlacesWereRenamedIsAnother) {
    const fs::path path = folder_.path("town.noonmark.gpkg");
    const auto ask = [](const std::vector<std::string>& words) {
        const CommandOutput output = noonmarkCli(words);
        ASSERT_EQ(output.code, exitOk) << output.err;
    };
    const auto nameLawn = [&](const std::string& name) {
        ProjectFile file = ProjectFile::open(path).value();
        Project project = file.project();
        project.places = {{name, PlaceKind::park, {{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {}}}, "drawn"}};
        ASSERT_TRUE(file.save(project));
    };
    ask({"project", "new", path.string(), folder_.path("houses.geojson").string()});
    nameLawn("Lawn");
    ask({"by-place", path.string(), "--kind", "park", "--start", "2026-03-21", "--from", "09:00", "--hours",
         "2", "--step", "20", "--zone", "America/New_York", "--out", folder_.path("filed").string()});
    ask({"project", "add-scenario", path.string(), "Tower"});
    EXPECT_EQ(verify("filed/places.json").code, exitOk) << "it was saved again";
    nameLawn("Meadow");
    EXPECT_EQ(verify("filed/places.json").code, exitUsage);
}

TEST_F(VerifyCommand, AcceptsAProjectThatWasSavedAgainWithTheSameQuestion) {
    const std::string project = folder_.path("town.noonmark.gpkg").string();
    const auto run = [](const std::vector<std::string>& words) {
        const CommandOutput output = noonmarkCli(words);
        ASSERT_EQ(output.code, exitOk) << output.err;
    };
    run({"project", "new", project, folder_.path("houses.geojson").string()});
    run({"project", "add-scenario", project, "Tower"});
    run({"study",      project,
         "--scenario", "Tower",
         "--start",    "2026-03-21",
         "--from",     "09:00",
         "--hours",    "6",
         "--step",     "10",
         "--zone",     "America/New_York",
         "--region",   "-73.9845,40.7525,-73.9828,40.7536",
         "--cell",     "2",
         "--out",      folder_.path("filed").string()});
    run({"project", "lot", "add", project, "Lot", "-73.9836,40.7532,-73.9834,40.7534"});
    for (const char* report : {"filed/report.pdf", "filed/study.json"}) {
        const CommandOutput output = verify(report);
        EXPECT_EQ(output.code, exitOk) << output.err << output.out;
        const auto inputs = output.json()["inputs"];
        EXPECT_TRUE(std::ranges::any_of(inputs, [](const auto& file) { return file["saved_again"] == true; }))
            << inputs.dump();
    }
    fs::rename(folder_.path("houses.geojson"), folder_.path("moved.geojson"));
    const CommandOutput words = noonmarkCli({"verify", folder_.path("filed/study.json").string()});
    EXPECT_EQ(words.code, exitOk);
    EXPECT_THAT(words.out, HasSubstr("\n  houses.geojson: the project holds what was read from it\n"));
    run({"project", "extrude", project, "--scenario", "Tower", "--lot", "Lot", "--height", "30", "--id",
         "T"});
    const CommandOutput other = verify("filed/report.pdf");
    EXPECT_EQ(other.code, exitUsage);
    EXPECT_EQ(other.json()["verdict"], "not computed");
}

// Whatever the working folder: it is the same afterwards, and nothing is left behind.
TEST_F(VerifyCommand, LeavesNothingBehind) {
    const fs::path before = fs::current_path();
    const auto count = [this] {
        return std::distance(fs::recursive_directory_iterator(folder_.path("")),
                             fs::recursive_directory_iterator());
    };
    const auto files = count();
    EXPECT_EQ(verify("out/report.pdf").code, exitOk);
    EXPECT_EQ(fs::current_path(), before);
    EXPECT_EQ(count(), files);
}

// Adds to what the first page of the report draws.
void paintOver(const fs::path& report, const fs::path& painted, const std::string& drawn) {
    qpdf_data pdf = qpdf_init();
    EXPECT_EQ(qpdf_read(pdf, report.c_str(), nullptr), QPDF_SUCCESS);
    const qpdf_oh page = qpdf_get_page_n(pdf, 0), added = qpdf_oh_new_stream(pdf);
    qpdf_oh_replace_stream_data(pdf, added, reinterpret_cast<const unsigned char*>(drawn.data()),
                                drawn.size(), qpdf_oh_new_null(pdf), qpdf_oh_new_null(pdf));
    const qpdf_oh contents = qpdf_oh_new_array(pdf);
    qpdf_oh_append_item(pdf, contents, qpdf_oh_get_key(pdf, page, "/Contents"));
    qpdf_oh_append_item(pdf, contents, added);
    qpdf_oh_replace_key(pdf, page, "/Contents", contents);
    EXPECT_EQ(qpdf_init_write(pdf, painted.c_str()), QPDF_SUCCESS);
    EXPECT_EQ(qpdf_write(pdf), QPDF_SUCCESS);
    qpdf_cleanup(&pdf);
}

TEST_F(VerifyCommand, FindsAPageThatWasPaintedOver) {
    paintOver(folder_.path("out/report.pdf"), folder_.path("out/same.pdf"), " ");
    const CommandOutput same = verify("out/same.pdf");
    EXPECT_EQ(same.code, exitOk) << same.out;
    EXPECT_EQ(same.json()["pages"]["different"].dump(), "[]");
    EXPECT_GE(same.json()["pages"]["compared"], 1);
    // The words stay as they are: a white field lies over them.
    paintOver(folder_.path("out/report.pdf"), folder_.path("out/covered.pdf"), " 1 g 300 300 6000 3000 re f");
    const CommandOutput covered = verify("out/covered.pdf");
    EXPECT_EQ(covered.code, exitFailed) << covered.out;
    EXPECT_EQ(covered.json()["verdict"], "differs");
    EXPECT_EQ(covered.json()["pages"]["different"].dump(), "[1]");
    EXPECT_EQ(covered.json()["printed"]["differences"].size(), 0U);
}

TEST_F(VerifyCommand, ReadsTablesAsOthersDo) {
    const CommandOutput points = noonmarkCli({"study",       folder_.path("houses.geojson").string(),
                                              "--start",     "2026-03-21",
                                              "--from",      "09:00",
                                              "--hours",     "6",
                                              "--step",      "10",
                                              "--zone",      "America/New_York",
                                              "--region",    "-73.9845,40.7525,-73.9828,40.7536",
                                              "--receivers", "points",
                                              "--point",     "-73.9842,40.7531",
                                              "--out",       folder_.path("points").string()});
    ASSERT_EQ(points.code, exitOk) << points.err;
    const auto verified = verify("points/study.json").json();
    EXPECT_EQ(verified["verdict"], "agrees");
    EXPECT_EQ(verified["tables"][0]["name"], "elements.csv");
    EXPECT_GT(verified["tables"][0]["compared"], 10);
    EXPECT_THAT(verified["not_compared"].dump(), HasSubstr("elements.gpkg"));
    alter("points/elements.csv", "point 1,point", "1,234.5,point 1,point");
    const CommandOutput output = verify("points/study.json");
    EXPECT_EQ(output.code, exitFailed);
    EXPECT_THAT(output.json()["tables"][0]["differences"].dump(), HasSubstr("fields"));
}

TEST_F(VerifyCommand, FindsAnAlteredFigure) {
    alter("out/study.json", "\"receivers\": ", "\"receivers\": 1");
    const CommandOutput output = verify("out/study.json");
    EXPECT_EQ(output.code, exitFailed);
    EXPECT_EQ(output.json()["verdict"], "differs");
    EXPECT_EQ(output.json()["figures"]["differences"][0]["key"], "receivers");
}

TEST_F(VerifyCommand, ComputesNothingFromOtherInputs) {
    alter("houses.geojson", "\"height\":40", "\"height\":41");
    const CommandOutput other = verify("out/report.pdf");
    EXPECT_EQ(other.code, exitUsage);
    EXPECT_EQ(other.json()["verdict"], "not computed");
    fs::remove(folder_.path("houses.geojson"));
    EXPECT_EQ(verify("out/report.pdf").json()["inputs"][0]["found"], nullptr);
}

TEST_F(VerifyCommand, RefusesWhatIsNoReport) {
    std::ofstream(folder_.path("empty.pdf")) << "%PDF-1.4\n";
    std::ofstream(folder_.path("text.json")) << "{}";
    std::filesystem::create_directory(folder_.path("bare"));
    for (const char* file : {"empty.pdf", "text.json", "houses.geojson", "gone.pdf", "bare"}) {
        const CommandOutput output = verify(file);
        EXPECT_EQ(output.code, exitUsage) << file;
        EXPECT_FALSE(output.err.empty()) << file;
    }
}

}  // namespace
}  // namespace noonmark::cli::tests
