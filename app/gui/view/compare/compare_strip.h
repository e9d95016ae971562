#pragma once

#include <QWidget>
#include <string>
#include <vector>

class QComboBox;
class QLabel;

namespace noonmark {

class ProjectSession;

/// The strip above the view while it compares two scenarios: a list of the others on the left, the displayed
/// scenario on the right, and what the view shows of both between them.
class CompareStrip final : public QWidget {
    Q_OBJECT
public:
    explicit CompareStrip(ProjectSession& session, QWidget* parent = nullptr);  ///< it must outlive this

    void setOther(const std::string& scenario);
    void setNote(const QString& note);

Q_SIGNALS:
    void otherChosen(const std::string& scenario);
    void closed();

private:
    void fill();

    ProjectSession& session_;
    QComboBox* other_;
    QLabel* note_;
    QLabel* displayed_;
};

/// Every scenario but the displayed one, the existing city among them.
std::vector<std::string> listOthers(const ProjectSession& session);

}  // namespace noonmark
