; The search of a flat (thesis 4.2.3): view triangles are explored, regions of interest examined from a viewpoint.
; Costs are path lengths in centimetres.
(define (domain search)
  (:requirements :strips :typing :action-costs)
  (:types robot waypoint region)
  (:predicates
    (robot_at ?r - robot ?wp - waypoint)
    (connected ?from ?to - waypoint)
    (view_triangle ?wp - waypoint)
    (viewpoint ?wp - waypoint ?x - region)
    (explored ?wp - waypoint)
    (examined ?x - region))
  (:functions
    (way ?from ?to - waypoint)
    (total-cost))
  (:action goto_waypoint
    :parameters (?r - robot ?from ?to - waypoint)
    :precondition (and (robot_at ?r ?from) (connected ?from ?to))
    :effect (and (not (robot_at ?r ?from)) (robot_at ?r ?to) (increase (total-cost) (way ?from ?to))))
  (:action explore_waypoint
    :parameters (?r - robot ?wp - waypoint)
    :precondition (and (robot_at ?r ?wp) (view_triangle ?wp))
    :effect (explored ?wp))
  (:action examine_region
    :parameters (?r - robot ?wp - waypoint ?x - region)
    :precondition (and (robot_at ?r ?wp) (viewpoint ?wp ?x))
    :effect (examined ?x)))
