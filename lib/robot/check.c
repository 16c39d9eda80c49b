#include "quarter/policy.h"
#include "quarter/status.h"
#include "robot/checks.h"

int qtr_policy_check(const qtr_policy *policy) {
  int status = qtr_check_sections(policy);
  if (status == QTR_OK) {
    status = qtr_check_travel(policy);
  }
  if (status == QTR_OK) {
    status = qtr_check_certificate(policy);
  }
  return status;
}
