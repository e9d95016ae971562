#pragma once

#include <QString>
#include <QWidget>
#include <map>
#include <vector>

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
    void tellScreening(std::size_t reached, std::size_t of);

Q_SIGNALS:
    void chosen(bool all, std::vector<std::string> names);
    void screenRequested();
    void pointedAt(const std::string& place);  ///< the current row

private:
    void take();
    void checkAll(bool on);
    void filter(const QString& part);
    void count();

    QLineEdit* filter_;
    QListWidget* list_;
    QLabel* count_;
};

}  // namespace noonmark
