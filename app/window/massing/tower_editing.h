#pragma once

// The design of a tower on a lot. TowerDraft is the tower with its settings, TowerEditing the tool that shows
// it in the view; MassingPanel, its form, fields and table only show and change values.

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/window/editing/edit_context.h"
#include "app/window/massing/tower_draft.h"

namespace noonmark {

class MassingPanel;

/// A tower being designed; form, handle and preview show the same draft. Building it emits one list of edits.
/// A built tower can be redesigned from the draft it was built from.
class TowerEditing final : public QObject {
    Q_OBJECT
public:
    TowerEditing(EditContext& context, MassingPanel& panel,
                 QObject* parent = nullptr);  ///< both outlive it

    /// `replaces`: id of the building that the tower replaces; empty: none.
    void begin(const NamedLot& lot, const std::string& replaces, int storeys = 10);
    /// The draft of a tower that was built here and has not been changed since. Nothing for any other
    /// building, even if it has the same id in another scenario.
    [[nodiscard]] std::optional<TowerDraft> designOf(const Building& building) const;
    void resume(TowerDraft draft);
    [[nodiscard]] const std::optional<TowerDraft>& draft() const { return draft_; }
    [[nodiscard]] bool active() const { return draft_.has_value(); }

    void setHeight(double heightM);  ///< from the handle
    void build();                    ///< does nothing while the draft is invalid
    void show();                     ///< again, in the current city
    void cancel();
    void forget();  ///< ends the design and forgets all drafts: another city was opened

Q_SIGNALS:
    void began();
    void editsMade(std::vector<noonmark::Edit> edits, QString what, std::string tower);
    void ended();

private:
    struct Built {
        std::shared_ptr<const Building> tower;
        TowerDraft design;
    };

    void take();

    EditContext& context_;
    MassingPanel& panel_;
    std::optional<TowerDraft> draft_;
    std::vector<Edit> edits_;  ///< of the draft; empty while it is invalid
    std::vector<Built> built_;
};

}  // namespace noonmark
