#include <gtest/gtest.h>

#include <fstream>

#include "app/gui/tools/editing/edit_tools.h"
#include "core/city/building_heights.h"
#include "scenarios/edits/placed_building.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

struct ReloadWindow : test::ProjectWindow {
    QString mesh = folder.filePath(QStringLiteral("proposal.obj"));

    void writeBox(double heightM) {
        std::ofstream box(mesh.toStdString());
        for (const double z : {0.0, heightM})
            for (const auto& [x, y] :
                 {std::pair(0, 0), std::pair(10, 0), std::pair(10, 10), std::pair(0, 10)})
                box << "v " << x << ' ' << y << ' ' << z << '\n';
        box << "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    }
    MeshPlacing& placing() { return window->tools().mesh(); }
    const Building* proposal() {
        const auto& buildings = workbench().city()->city().buildings;
        return buildings.size() == 4 ? buildings.back().get() : nullptr;
    }
    void read() {
        placing().begin(mesh, {});
        ASSERT_TRUE(waitFor([this] { return placing().active(); }, 10000));
    }
};

TEST_F(ReloadWindow, AnotherEditionKeepsTheEditsThatFollow) {
    writeBox(30);
    read();
    placing().placeAt({0, 40});
    placing().build();
    ASSERT_TRUE(waitFor([this] { return proposal() != nullptr; }));
    const std::string id = proposal()->sourceId, scenario = session().scenario();
    ASSERT_TRUE(session().addEdits({Move{id, {20, 5}}}, QStringLiteral("move")));
    ASSERT_TRUE(waitFor([this] { return proposal() && findMiddle(*proposal()).x > 19; }));
    writeBox(50);
    read();
    placing().reload();
    ASSERT_TRUE(waitFor([this] { return proposal() && topM(*proposal()) > 49; })) << message().toStdString();
    EXPECT_NEAR(findMiddle(*proposal()).x, 20, 0.01);
    EXPECT_NEAR(findMiddle(*proposal()).y, 45, 0.01);
    EXPECT_EQ(proposal()->sourceId, id);
    EXPECT_EQ(findScenario(session().project().scenarios, scenario)->edits.size(), 2U);
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([this] { return proposal() && topM(*proposal()) < 31; })) << "one undo step";
}

}  // namespace
}  // namespace noonmark
