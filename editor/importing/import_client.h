// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Queue of queries for the import thread, in the order of their urgency, one query at a time.

#include <list>
#include <memory>
#include <optional>
#include <QObject>
#include <QPointer>
#include <QThread>

#include "editor/importing/import_worker.h"

namespace detent::editor {

/// Urgency of a query. A running `background` query makes way for a more urgent one and is repeated later.
enum class Urgency { background, visible, now };

/// Sends queries to the import thread and receives its answers. GUI thread. Never waits: the destructor stops
/// the running work, and the thread ends by itself.
class ImportClient : public QObject {
  Q_OBJECT

 public:
  using Ticket = quint64;  ///< 0: no request

  explicit ImportClient(QObject* parent = nullptr);
  ~ImportClient() override;
  ImportClient(const ImportClient&) = delete;
  ImportClient& operator=(const ImportClient&) = delete;

  /// Queues a query behind those of the same urgency. The answer comes as `answered`, unless the ticket is
  /// forgotten.
  Ticket ask(Query query, Urgency urgency);
  /// Drops a query whose answer is not wanted any more, and stops it if it runs. Unknown tickets and 0 are
  /// ignored.
  void forget(Ticket ticket);
  void forgetAll();
  /// Returns true if the query is queued or running.
  bool isOpen(Ticket ticket) const;

 signals:
  void answered(ImportClient::Ticket ticket, std::shared_ptr<const Answer> answer);
  void progressed(ImportClient::Ticket ticket, double fraction, importer::ImportStep step);

 private:
  struct Question {
    Ticket ticket = 0;
    Query query;
    Urgency urgency = Urgency::background;
  };
  struct Running {
    Question question;
    ImportWorker::StopFlag stop;
    bool forgotten = false, interrupted = false;
  };
  void enqueue(Question question, bool before);
  void startNext();
  void finish(Ticket ticket, const std::shared_ptr<const Answer>& answer);

  QThread* thread_;  ///< deletes itself when it has ended
  QPointer<ImportWorker> worker_;
  std::list<Question> queue_;  ///< most urgent first
  std::optional<Running> running_;
  Ticket last_ = 0;
};

}  // namespace detent::editor
