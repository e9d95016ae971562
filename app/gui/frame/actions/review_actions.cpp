#include "app/gui/frame/actions/review_actions.h"

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/verdict_words.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

ReviewActions::ReviewActions(ReviewSession& review, GlazingSession& windows, ReviewDock& dock,
                             EditPreview& preview, PlaceActions& places, ViewPanel& panel)
    : review_(review),
      windows_(windows),
      panel_(panel),
      show_(makeAction(this, tr("Re&view by a rule..."), QKeySequence(tr("Ctrl+Shift+R")),
                       tr("Evaluate the rule of a review board on the places of the project"), "review")),
      export_(makeAction(this, tr("Export t&he review..."), {},
                         tr("Shows the sheets of the review, and writes them with its tables and drawings"),
                         "sheets")) {
    show_->setObjectName(QStringLiteral("reviewByRule"));
    connect(show_, &QAction::triggered, this, &ReviewActions::dockWanted);
    connect(export_, &QAction::triggered, this, &ReviewActions::exportReview);
    connect(&dock, &ReviewDock::exportRequested, this, &ReviewActions::exportReview);
    connect(&dock, &ReviewDock::placePointedAt, &panel_, &ViewPanel::highlightPlace);
    connect(&dock, &ReviewDock::zoomRequested, &places, &PlaceActions::zoomTo);
    connect(&review_, &ReviewSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&windows_, &GlazingSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&review_, &ReviewSession::noted, &panel_.messages(), &MessageBar::showNote);
    connect(&preview, &EditPreview::shapeChanged, &review_, &ReviewSession::shape);
    connect(&review_, &ReviewSession::answered, this, [this, &preview] { tellVerdicts(preview); });
}

// On the building that is being shaped.
void ReviewActions::tellVerdicts(EditPreview& preview) const {
    if (!review_.isLive()) return preview.setVerdicts({});
    const ReviewStudy& study = review_.shown()->study;
    preview.setVerdicts(tr("%1: %2").arg(QString::fromStdString(study.rule.name), describeVerdicts(study)));
}

void ReviewActions::exportReview() {
    const auto shown = windows_.applies() ? windows_.showFinished() : review_.showFinished();
    if (!shown) return panel_.messages().showError(shown.error());
    Q_EMIT exportWanted();
}

}  // namespace noonmark
