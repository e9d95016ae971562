#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFocusEvent>
#include <QKeyEvent>

#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/tools/editing/selection_panel.h"
#include "scenarios/edits/apply_edits.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {

/// The edit tools in a view of the small city. Edits come back as a changed city, as a project would send
/// them.
struct EditToolsTest : ::testing::Test {
    ViewPanel view;
    EditTools tools{view};
    std::shared_ptr<const OpenCity> city = test::smallOpenCity();
    std::vector<std::vector<Edit>> made;
    std::vector<Edit> all;
    std::vector<NamedLot> lots;
    bool cityComesBack = true;  // false: the project has not answered yet

    void SetUp() override {
        view.resize(900, 700);
        view.show();
        QObject::connect(&tools, &EditTools::editsMade,
                         [this](const std::vector<Edit>& edits, const QString& what) {
                             EXPECT_FALSE(what.isEmpty());
                             made.push_back(edits);
                             all.insert(all.end(), edits.begin(), edits.end());
                             tools.setTowers(findProposedTowers(all));
                             if (cityComesBack) show(applyEdits(city->city(), edits).value().city);
                         });
        QObject::connect(&tools, &EditTools::lotDrawn, [this](const NamedLot& lot) {
            lots.push_back(lot);
            tools.setLots(lots);
        });
        show(city->city());
    }

    void show(const City& edited) {
        auto open = std::make_shared<OpenCity>(*city);
        open->loaded.read.city = edited;
        open->picker = ScenePicker(edited, RayScene::over(edited).value());
        city = open;
        view.showCity(city);
        tools.setCity(city);
    }

    template <class Edited>
    const Edited& lastEdit() {
        return std::get<Edited>(made.back().back());
    }
    template <class Widget>
    Widget& field(QWidget* dock, const char* name) {
        return *dock->findChild<Widget*>(QLatin1String(name));
    }
    QDoubleSpinBox& number(const char* name) { return field<QDoubleSpinBox>(tools.dock(), name); }
    QDoubleSpinBox& number(QWidget* dock, const char* name) { return field<QDoubleSpinBox>(dock, name); }
    static void enter(QDoubleSpinBox& field) {
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QCoreApplication::sendEvent(&field, &press);
    }
    static void leave(QDoubleSpinBox& field) {
        QFocusEvent out(QEvent::FocusOut, Qt::MouseFocusReason);
        QCoreApplication::sendEvent(&field, &out);
    }
    [[nodiscard]] QPointF pixelAt(glm::dvec3 point) {
        const auto pixel = pixelOf(view.view().pose(), view.view().lens(), point);
        return {pixel->x, pixel->y};
    }
    void dragTheLowHouse() {
        view.navigator().show({{-200, -200}, {200, 200}});
        tools.building().select(1);
        tools.building().setMoving(true);
        ASSERT_TRUE(tools.building().moveTool().grab(pixelAt({75, 35, 25})));
        tools.building().moveTool().dragTo(pixelAt({95, 25, 25}));
        ASSERT_TRUE(test::waitFor([this] { return tools.context().preview.shown(); }));
    }
    [[nodiscard]] double massOf(std::size_t building) const {
        return collectFacts(*city->city().buildings[building], city->city()).grossFloorM2.value_or(0);
    }
    void drawLot(std::initializer_list<glm::dvec2> corners) {
        tools.drawLot();
        for (const glm::dvec2 corner : corners) view.lotTool().addPoint({corner, 0});
        view.lotTool().finish();
    }
};

}  // namespace noonmark
