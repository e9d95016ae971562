#include <QLabel>

#include "app/gui/docks/review/review_session.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/panel/legend_strip.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::newTower;
using test::square;
using test::waitFor;

/// The small project with a park north of the new tower, which stands at (20, 20) and is 70 m high.
struct LiveEffectWindow : test::ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        StudySettings study = workbench().document().settings();
        study.period.zone = "America/New_York";
        workbench().document().change(study, QStringLiteral("zone"));
        Project next = session().project();
        next.places.push_back({"Park", PlaceKind::park, {square({10, 60}, 40)}, "drawn"});
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
    }
    EditTools& tools() { return window->tools(); }
    EditPreview& preview() { return tools().context().preview; }
    OverlayBodies& overlay() { return tools().context().panel.view().overlay(); }
    QString effect() { return window->findChild<QLabel*>(QStringLiteral("editEffect"))->text(); }
    QString legend() { return tools().context().panel.legend().legend()->title; }
};

TEST_F(LiveEffectWindow, ShowsTheChangeWithItsFiguresAndTheWorstSpot) {
    ASSERT_TRUE(tools().changeAction().isChecked());
    EXPECT_FALSE(tools().facadesAction().isChecked());
    ASSERT_TRUE(preview().show({newTower("New", 70)}));
    ASSERT_TRUE(waitFor([this] { return !effect().isEmpty(); }));
    const LiveChange& change = *preview().live().answer()->change;
    EXPECT_GT(change.figures[0].gross.moreShadowM2, 0);
    EXPECT_TRUE(effect().startsWith(QStringLiteral("New shadow a day, by cells of ")))
        << effect().toStdString();
    EXPECT_TRUE(effect().contains(QStringLiteral("Worst spot: +"))) << effect().toStdString();
    EXPECT_TRUE(effect().contains(QStringLiteral("\nPark: "))) << effect().toStdString();
    EXPECT_EQ(legend(), QStringLiteral("Change of gross shadow"));
    ASSERT_TRUE(overlay().worstSpot());
    tools().changeAction().trigger();
    EXPECT_EQ(legend(), QStringLiteral("Gross shadow"));
    EXPECT_FALSE(overlay().worstSpot());
    EXPECT_FALSE(effect().isEmpty()) << "the figures stay";
    preview().clear();
    EXPECT_TRUE(effect().isEmpty());
}

TEST_F(LiveEffectWindow, ChangeAndFacadesExcludeEachOther) {
    tools().facadesAction().trigger();
    EXPECT_FALSE(tools().changeAction().isChecked());
    tools().changeAction().trigger();
    EXPECT_FALSE(tools().facadesAction().isChecked());
    tools().changeAction().trigger();
    EXPECT_FALSE(tools().facadesAction().isChecked()) << "both may be off";
}

TEST_F(LiveEffectWindow, TheChosenBaselineIsTheOneComparedWith) {
    build();
    ASSERT_TRUE(preview().show({ChangeHeight{"New", 40}}));
    ASSERT_TRUE(waitFor([this] { return !effect().isEmpty(); }));
    EXPECT_GT(preview().live().answer()->change->figures[0].gross.moreShadowM2, 0)
        << "against the existing city";
    session().compareWith(session().scenario());
    ASSERT_TRUE(waitFor([this] { return effect().startsWith(QStringLiteral("No new shadow")); }))
        << effect().toStdString();
    EXPECT_GT(preview().live().answer()->change->figures[0].gross.anyLessShadowM2, 0)
        << "a lower tower shades less";
}

TEST_F(LiveEffectWindow, VerdictsFollowAQuickReviewWithoutItsDock) {
    build();
    ReviewSession& review = window->review();
    ReviewChoice choice = review.choice();
    choice.rule = "ceqr";
    review.choose(choice);
    ASSERT_TRUE(preview().show({ChangeHeight{"New", 60}}));
    EXPECT_FALSE(review.following().busy()) << "no review was run";
    preview().clear();
    review.run();
    ASSERT_TRUE(waitFor([&] { return !review.running().busy(); }));
    ASSERT_TRUE(preview().show({ChangeHeight{"New", 50}}));
    ASSERT_TRUE(waitFor([&] { return review.isLive(); }));
    ASSERT_TRUE(waitFor([this] { return effect().contains(QStringLiteral("CEQR")); }))
        << effect().toStdString();
    const std::string verdict(nameOf(review.shown()->study.places.at(0).verdict));
    const QString last = effect().split(u'\n').last();
    EXPECT_TRUE(last.startsWith(QStringLiteral("New York, CEQR chapter 8: 1 "))) << last.toStdString();
    EXPECT_TRUE(last.endsWith(QString::fromStdString(verdict))) << last.toStdString();
}

TEST_F(LiveEffectWindow, WithoutALiveShadowNoFiguresStay) {
    ASSERT_TRUE(preview().show({newTower("New", 70)}));
    ASSERT_TRUE(waitFor([this] { return !effect().isEmpty(); }));
    StudySettings night = workbench().document().settings();
    night.period.from = std::chrono::hours(0);
    night.period.hours = 1;
    workbench().document().change(night, QStringLiteral("night"));
    EXPECT_TRUE(effect().isEmpty()) << effect().toStdString();
    ASSERT_TRUE(waitFor([this] { return !preview().working().busy(); }));
    EXPECT_TRUE(effect().isEmpty()) << effect().toStdString();
    EXPECT_FALSE(overlay().worstSpot());
}

}  // namespace
}  // namespace noonmark
