#pragma once

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>

#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "tests/gui/project_window.h"

namespace noonmark::test {

/// Rules about windows, on the facades of the small project, with a new tower in it.
struct GlazingReviewWindow : ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        StudySettings study = workbench().document().settings();
        study.period.zone = "Europe/Amsterdam";
        workbench().document().change(study, QStringLiteral("zone"));
        for (QDockWidget* one : window->findChildren<QDockWidget*>())
            if (one->isAncestorOf(&dock()) || one->isAncestorOf(&question())) one->show(), one->raise();
        ASSERT_TRUE(waitFor([this] { return dock().isVisible() && question().isVisible(); }));
        choose("en-17037");
    }
    GlazingSession& windows() { return window->glazingReview(); }
    ReviewDock& dock() { return *window->findChild<ReviewDock*>(); }
    ReviewForm& question() { return *window->findChild<ReviewForm*>(); }
    GlazingForm& form() { return *question().findChild<GlazingForm*>(); }
    QString state() { return dock().findChild<QLabel*>(QStringLiteral("reviewState"))->text(); }
    void choose(const std::string& rule) {
        ReviewChoice choice = window->review().choice();
        choice.rule = rule;
        window->review().choose(choice);
    }
    void run() {
        question().findChild<QPushButton*>(QStringLiteral("runReview"))->click();
        ASSERT_TRUE(waitFor([this] { return !windows().running().busy(); }));
    }
};

}  // namespace noonmark::test
