#pragma once

// The design of a tower on a lot. TowerDraft is the tower with its settings, TowerEditing the tool that shows
// it in the view; MassingPanel, its form, fields and table only show and change values.

#include <QObject>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/tools/massing/massing_form.h"
#include "app/gui/tools/preview/edit_context.h"
#include "scenarios/massing/copy_massing.h"
#include "scenarios/massing/fit_floor_area.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

class MassingPanel;

/// A tower being designed; form, handle and preview show the same draft. Building it emits one list of edits.
/// A built tower can be redesigned, and copied, from the design that the project saved with its edit.
class TowerEditing final : public QObject {
    Q_OBJECT
public:
    TowerEditing(EditContext& context, MassingPanel& panel,
                 QObject* parent = nullptr);  ///< both outlive it

    /// `replaces`: id of the building that the tower replaces; empty: none.
    void begin(const NamedLot& lot, const std::string& replaces,
               const MassingSettings& settings = {.storeys = 10});
    /// The values of the last tower that was built, as far as they fit this lot; at first ten storeys.
    [[nodiscard]] CopiedMassing lastValuesOn(const Footprint& lot) const;
    /// The towers of the shown scenario.
    void setTowers(std::map<std::string, ProposedTower> towers);
    [[nodiscard]] const std::map<std::string, ProposedTower>& towers() const { return context_.towers; }
    /// The draft that a designed tower was built from; nothing for any other building, nor where it was
    /// changed since.
    [[nodiscard]] std::optional<TowerDraft> designOf(const Building& building) const;
    /// The same also where the tower was moved, turned or changed in height since: for a copy.
    [[nodiscard]] std::optional<TowerDraft> designToCopy(const Building& building) const;
    void resume(TowerDraft draft);
    [[nodiscard]] const std::optional<TowerDraft>& draft() const { return draft_; }
    [[nodiscard]] bool active() const { return draft_.has_value(); }

    void setHeight(double heightM);  ///< from the handle
    void build();                    ///< does nothing while the draft is invalid
    void show();                     ///< again, in the current city
    void showInRegion();             ///< whether it is measured; the region may have changed
    void cancel();

Q_SIGNALS:
    void regionRequested(noonmark::Region region);  ///< of the study
    void began();
    void editsMade(std::vector<noonmark::Edit> edits, QString what, std::string tower);
    void ended();

private:
    void take();
    void fit(const FloorAreaTarget& target);
    void takeNearest();
    void showImpossible(const Error& error);

    EditContext& context_;
    MassingPanel& panel_;
    std::optional<TowerDraft> draft_;
    std::vector<Edit> edits_;                  ///< of the draft; empty while it is invalid
    std::optional<MassingSettings> possible_;  ///< of the draft, as they could be built last
    std::optional<NearestFit> nearest_;        ///< to what cannot be built
    struct Fit {
        double wantedM2;
        MassingSettings from, fitted;
    };
    std::optional<Fit> fit_;           ///< the last one of the draft
    std::optional<TowerDraft> built_;  ///< the last tower
};

}  // namespace noonmark
