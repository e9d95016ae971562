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

}  // namespace
}  // namespace noonmark::tests
