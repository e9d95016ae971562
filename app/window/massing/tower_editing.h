#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/window/massing/edit_desk.h"
#include "app/window/massing/tower_draft.h"

namespace noonmark {

class MassingPanel;

/// A tower while it is designed: form, handle and preview say the same. Building it is one list of edits; it
/// can be designed again afterwards from what it was made of.
class TowerEditing final : public QObject {
    Q_OBJECT
public:
    TowerEditing(EditSession& workspace, MassingPanel& panel,
                 QObject* parent = nullptr);  ///< both outlive it

    /// `replaces`: id of a building whose place it takes; empty: none.
    void begin(const NamedLot& lot, const std::string& replaces, int storeys = 10);
    /// The design of a tower that was built here and still is as it was built; none of any other building,
    /// though it should bear the same id in another scenario.
    [[nodiscard]] std::optional<TowerDraft> designOf(const Building& building) const;
    void resume(TowerDraft draft);
    [[nodiscard]] bool active() const { return draft_.has_value(); }

    void setHeight(double heightM);  ///< from the handle
    void build();                    ///< does nothing while the draft cannot be
    void show();                     ///< again, in the city as it is now
    void cancel();
    void forget();  ///< another city: designs too

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

    EditSession& desk_;
    MassingPanel& panel_;
    std::optional<TowerDraft> draft_;
    std::vector<Edit> edits_;  ///< of the draft; empty while it cannot be
    std::vector<Built> built_;
};

}  // namespace noonmark
