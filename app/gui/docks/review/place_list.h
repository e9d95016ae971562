#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/docks/review/review_session.h"
#include "app/questions/review_question.h"
#include "core/receivers/place.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace noonmark {

/// The places to review, each with a check box: those that a review of now has.
class PlaceList final : public QWidget {
    Q_OBJECT
public:
    explicit PlaceList(QWidget* parent = nullptr);

    /// `reach`: the places in reach, where these are reviewed and known; null: not so. `isFinding`: they are
    /// still to be found; until then none can be ticked.
    void show(const std::vector<Place>& places, const ReviewChoice& choice, const ReviewSession::Reach* reach,
              bool isFinding);

    /// The kinds that can be drawn, those that the rule is about; none: it is about no places.
    void setKinds(const std::vector<PlaceKind>& kinds);
    void editName(const std::string& place);  ///< in its row

Q_SIGNALS:
    void chosen(bool all, std::vector<std::string> names);
    void screenRequested();
    void drawRequested(noonmark::PlaceKind kind);
    void renamed(const std::string& from, const std::string& to);
    void highlighted(const std::string& place);  ///< the current row

private:
    /// A name that is being typed in a row, not yet taken.
    struct Typing {
        QString place, text;
    };

    QWidget* makeDrawing();
    std::optional<Typing> stopTyping();
    void resumeTyping(const Typing& typing);
    [[nodiscard]] QLineEdit* typingIn(const QListWidgetItem& item) const;
    [[nodiscard]] QListWidgetItem* rowOf(const QString& place) const;
    void takeItem(const QListWidgetItem& item);
    void take();
    void checkAll(bool on);
    void filter(const QString& part);
    void count();
    void showReach(std::size_t reached, std::size_t of);

    QLineEdit* filter_;
    QListWidget* list_;
    QLabel* count_;
    QComboBox* kind_;
    QWidget* drawing_;
};

/// The reviewed places in the colours of their verdicts, for the view, with a legend of them. A parcel has
/// two reviews: the worse one colours it. Null for a null answer. Some 50 ms for 5,000 places.
std::shared_ptr<const PlaceView> makePlaceVerdicts(const std::shared_ptr<const ReviewAnswer>& answer);

}  // namespace noonmark
