; What the robot can do while it searches the floor for what was not there before (thesis 4.2.3).
; Waypoints are poses to look from: one for each view triangle, some round each region of interest.
(define (domain search)
  (:requirements :strips :typing :action-costs)
  (:types robot waypoint triangle region)
  (:predicates
    (robot_at ?robot - robot ?wp - waypoint)
    (connected ?from ?to - waypoint)             ; the robot can drive from one to the other
    (views ?wp - waypoint ?triangle - triangle)  ; from here this part of the floor is seen
    (viewpoint ?wp - waypoint ?region - region)  ; from here this region can be segmented
    (explored ?triangle - triangle)
    (examined ?region - region))
  (:functions
    (total-cost) - number
    (distance ?from ?to - waypoint) - number)    ; length of the path in centimetres

  (:action goto_waypoint
    :parameters (?robot - robot ?from ?to - waypoint)
    :precondition (and (robot_at ?robot ?from) (connected ?from ?to))
    :effect (and (not (robot_at ?robot ?from)) (robot_at ?robot ?to)
                 (increase (total-cost) (distance ?from ?to))))

  (:action explore_waypoint
    :parameters (?robot - robot ?wp - waypoint ?triangle - triangle)
    :precondition (and (robot_at ?robot ?wp) (views ?wp ?triangle))
    :effect (explored ?triangle))

  (:action examine_region
    :parameters (?robot - robot ?wp - waypoint ?region - region)
    :precondition (and (robot_at ?robot ?wp) (viewpoint ?wp ?region))
    :effect (examined ?region)))
