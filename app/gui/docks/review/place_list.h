#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <memory>
#include <vector>

#include "app/gui/base/layers/field_picture.h"
#include "app/questions/review_question.h"
#include "core/receivers/place.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace noonmark {

/// The places to review, each with a check box; all at first. Screen asks which of them can be reached.
class PlaceList final : public QWidget {
    Q_OBJECT
public:
    explicit PlaceList(QWidget* parent = nullptr);

    /// `reasons`: what screening found about a place, by name.
    void show(const std::vector<Place>& places, bool all, const std::vector<std::string>& chosen,
              const std::map<std::string, QString>& reasons);
    void showScreening(std::size_t reached, std::size_t of);

Q_SIGNALS:
    void chosen(bool all, std::vector<std::string> names);
    void screenRequested();
    void highlighted(const std::string& place);  ///< the current row

private:
    void take();
    void checkAll(bool on);
    void filter(const QString& part);
    void count();

    QLineEdit* filter_;
    QListWidget* list_;
    QLabel* count_;
};

/// The reviewed places in the colours of their verdicts, for the view, with a legend of them. A parcel has
/// two reviews: the worse one colours it. Null for a null answer. Some 50 ms for 5,000 places.
std::shared_ptr<const PlaceView> makePlaceVerdicts(const std::shared_ptr<const ReviewAnswer>& answer);

}  // namespace noonmark
