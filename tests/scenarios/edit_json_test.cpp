#include "scenarios/project/edit_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
