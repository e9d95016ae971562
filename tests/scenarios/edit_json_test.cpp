#include "scenarios/project/edit_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/settings/read_settings.h"
#include "scenarios/edits/read_shape.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    const auto at = text.find(old);
    EXPECT_NE(at, text.npos) << old;
    return text.replace(at, old.size(), with);
}

TEST(EditJson, CornersThatNoWholeNumberNamesAreRefused) {
    const Project project = sampleProject();
    const Edit import = project.scenarios.at(1).edits.back();
    const std::string text = toJson(import);
    ASSERT_TRUE(parseEdit("import", text));
    for (const char* corner : {"4294967296", "-1", "1e300", "0.5"}) {
        const auto edit = parseEdit("import", replaced(text, "\"triangles\":[[",
                                                       std::string("\"triangles\":[[") + corner + ",1,2],["));
        ASSERT_FALSE(edit) << corner;
        EXPECT_THAT(edit.error().what, HasSubstr("An edit cannot be read"));
    }
}

TEST(EditJson, AnImportRemembersHowItsFileWasRead) {
    const Project project = sampleProject();
    auto import = std::get<ImportMesh>(project.scenarios.at(1).edits.back());
    EXPECT_THAT(toJson(import), testing::Not(HasSubstr("read_scale")));
    import.reading = formatText(ReadSettings{.upAxis = UpAxis::y, .meshUnit = LengthUnit::inches});
    import.readScale = 0.5;
    const auto read = parseEdit("import", toJson(import));
    ASSERT_TRUE(read) << read.error().text();
    ReadSettings settings{.upAxis = UpAxis::z, .meshNorthDeg = 5};
    applyReading(std::get<ImportMesh>(*read), settings);
    EXPECT_EQ(settings.upAxis, UpAxis::y);
    EXPECT_EQ(settings.meshUnit, LengthUnit::inches);
    EXPECT_EQ(settings.meshScale, 0.5);
    EXPECT_EQ(settings.meshNorthDeg, 5) << "is not part of it";
    const auto later = parseEdit("import", replaced(toJson(import), "\"mesh_unit\"", "\"mesh_yard\""));
    ASSERT_TRUE(later) << "of a later version";
    EXPECT_FALSE(parseEdit("import", replaced(toJson(import), "\"read_scale\":0.5", "\"read_scale\":0")));
}

TEST(EditJson, EditsOfTreesComeBack) {
    Tree tree = completeTree({.sourceId = "planted 1", .species = "Tilia \"x\"", .crownDiameterM = 7.3});
    tree.place = {1.0 / 3, -250.125};
    tree.evergreen = true;
    tree.shape = CrownShape::cone;
    tree.heightSource = TreeSource::designed;
    const std::vector<Edit> edits{PlantTree{tree}, FellTree{"node 7"}, ReplaceTree{"node 8", tree},
                                  MoveTree{"node 9", {0.1, -2}}, GrowTree{"node 9", 12.5, 9.25, 2.5, 6.75}};
    for (const Edit& edit : edits) {
        const auto read = parseEdit(std::string(getKind(edit)), toJson(edit));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(*read, edit) << toJson(edit);
    }
    EXPECT_FALSE(parseEdit("plant", replaced(toJson(edits[0]), "\"leaf_on\":", "\"leaf_on\":7,\"was\":")));
    EXPECT_FALSE(parseEdit("plant", replaced(toJson(edits[0]), "\"height_m\"", "\"high_m\"")));
}

}  // namespace
}  // namespace noonmark::tests
