(** Values of expressions at points with Gaussian rational coordinates, computed. *)

From Coq Require Import ZArith QArith List.
Require Import Expressions.
Import ListNotations.

Definition gauss : Type := (Q * Q)%type.

Definition gadd (x y : gauss) : gauss :=
  (Qred (fst x + fst y)%Q, Qred (snd x + snd y)%Q).
Definition gopp (x : gauss) : gauss := (Qred (- fst x)%Q, Qred (- snd x)%Q).
Definition gmul (x y : gauss) : gauss :=
  (Qred (fst x * fst y - snd x * snd y)%Q, Qred (fst x * snd y + snd x * fst y)%Q).
Definition gdiv (x y : gauss) : gauss :=
  let n := (fst y * fst y + snd y * snd y)%Q in
  gmul x (Qred (fst y / n)%Q, Qred (- snd y / n)%Q).
Definition gbar (x : gauss) : gauss := (fst x, Qred (- snd x)%Q).

Fixpoint gpow (x : gauss) (n : nat) : gauss :=
  match n with O => (1, 0)%Q | S n => gmul x (gpow x n) end.

Fixpoint at_point (p : nat -> gauss) (e : expr) : gauss :=
  match e with
  | Var n => p n
  | Num z => (inject_Z z, 0%Q)
  | Add a b => gadd (at_point p a) (at_point p b)
  | Opp a => gopp (at_point p a)
  | Mul a b => gmul (at_point p a) (at_point p b)
  | Div a b => gdiv (at_point p a) (at_point p b)
  | Pow a n => gpow (at_point p a) n
  end.

Definition equal (x y : gauss) : bool := Qeq_bool (fst x) (fst y) && Qeq_bool (snd x) (snd y).

Definition vanishes (x : gauss) : bool := equal x (0, 0)%Q.

(** The point with these coordinates. *)

Definition point (values : list gauss) (n : nat) : gauss := nth n values (0, 0)%Q.

(** The determinant of a matrix of rows in these columns, by its first row. *)

Fixpoint minor (rows : list (list gauss)) (columns : list nat) : gauss :=
  match rows with
  | [] => (1, 0)%Q
  | row :: rest =>
    (fix expand (before after : list nat) : gauss :=
       match after with
       | [] => (0, 0)%Q
       | n :: more =>
         let term := gmul (nth n row (0, 0)%Q) (minor rest (rev before ++ more)) in
         gadd (if Nat.even (length before) then term else gopp term) (expand (n :: before) more)
       end) [] columns
  end.
