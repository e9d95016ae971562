#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>

#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// Edit tools and project together, on the sample.
struct EditingWindowTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.path());
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->resize(1000, 700);
        window->show();
        window->open({QStringLiteral("sample:central-park-south")});
        ASSERT_TRUE(waitFor([this] { return window->workbench().city() != nullptr; }));
    }

    [[nodiscard]] const City& city() const { return window->workbench().city()->city(); }
    [[nodiscard]] std::optional<std::uint32_t> find(const std::string& name) const {
        const auto found = std::ranges::find(city().buildings, name, [](const auto& b) { return b->name; });
        if (found == city().buildings.end()) return std::nullopt;
        return std::uint32_t(found - city().buildings.begin());
    }
};

TEST_F(EditingWindowTest, ADemolitionIsAScenarioThatCanBeUndone) {
    const std::size_t before = city().buildings.size();
    const CameraPose pose = window->panel().view().pose();
    const auto tower = find("111 West 57th Street");
    ASSERT_TRUE(tower);
    window->tools().building().select(tower);
    window->tools().building().demolish();
    ASSERT_TRUE(waitFor([&] { return city().buildings.size() == before - 1; }));
    EXPECT_NE(window->workbench().session().scenario(), existingCity);
    EXPECT_EQ(window->panel().view().pose(), pose) << "an edit leaves the camera where it is";
    window->workbench().document().undoStack().undo();
    EXPECT_TRUE(waitFor([&] { return city().buildings.size() == before; }));
}

TEST_F(EditingWindowTest, ATowerOnADrawnLotIsPartOfTheProject) {
    window->tools().drawLot();
    const Box2 park = bounds(window->workbench().document().settings().region);
    const glm::dvec2 middle = glm::dvec2(park.low + park.high) / 2.0;
    for (const glm::dvec2 corner : {glm::dvec2{0, 0}, {40, 0}, {40, 40}, {0, 40}})
        window->panel().lotTool().addPoint({middle + corner, 0});
    window->panel().lotTool().finish();
    ASSERT_EQ(window->workbench().session().project().lots.size() > 0, true);
    ASSERT_TRUE(window->tools().tower().active()) << "adding the lot does not end the design";
    window->tools().tower().setHeight(140);
    window->tools().tower().build();
    ASSERT_TRUE(waitFor([this] { return find("Tower 1").has_value(); }));
    EXPECT_NEAR(double(topM(*city().buildings[*find("Tower 1")])), 140, 0.01);
    EXPECT_TRUE(waitFor([this] { return window->tools().building().id() == "Tower 1"; }));
}

}  // namespace
}  // namespace noonmark
