(** Values of expressions in any field, and what makes two values equal. *)

From Coq Require Import ZArith Field List.
Require Import Expressions.
Import ListNotations.

Section Values.

Variable R : Type.
Variables zero one : R.
Variables add mul sub : R -> R -> R.
Variable opp : R -> R.
Variable div : R -> R -> R.
Variable inv : R -> R.
Variable R_field : field_theory zero one add mul sub opp div inv (@eq R).
Add Field R_as_field : R_field.

Fixpoint positive_value (p : positive) : R :=
  match p with
  | xH => one
  | xO p => mul (add one one) (positive_value p)
  | xI p => add one (mul (add one one) (positive_value p))
  end.

Definition integer_value (z : Z) : R :=
  match z with
  | Z0 => zero
  | Zpos p => positive_value p
  | Zneg p => opp (positive_value p)
  end.

Fixpoint power_value (x : R) (n : nat) : R :=
  match n with
  | O => one
  | S O => x
  | S n => mul x (power_value x n)
  end.

Fixpoint value (v : nat -> R) (e : expr) : R :=
  match e with
  | Var n => v n
  | Num z => integer_value z
  | Add a b => add (value v a) (value v b)
  | Opp a => opp (value v a)
  | Mul a b => mul (value v a) (value v b)
  | Div a b => div (value v a) (value v b)
  | Pow a n => power_value (value v a) n
  end.

Variable v : nat -> R.
Notation val := (value v).

Lemma power_step (x : R) (n : nat) : power_value x (S n) = mul x (power_value x n).
Proof. destruct n; cbn; ring. Qed.

Lemma power_inverse (x y : R) (n : nat) :
  mul x y = one -> mul (power_value x n) (power_value y n) = one.
Proof.
  intros H. induction n as [|n I].
  - cbn. ring.
  - rewrite !power_step.
    transitivity (mul (mul x y) (mul (power_value x n) (power_value y n))); [ring|].
    rewrite H, I. ring.
Qed.

Lemma inverse_nonzero (x y : R) : mul x y = one -> x <> zero.
Proof. intros H E. apply (F_1_neq_0 R_field). rewrite <- H, E. ring. Qed.

Lemma quotient (x y z : R) : mul y z = one -> div x y = mul x z.
Proof.
  intros H. transitivity (mul (div x y) (mul y z)); [rewrite H; ring|].
  field. exact (inverse_nonzero _ _ H).
Qed.

Lemma reciprocal (d : expr) : val d <> zero -> val (d * (1 / d)) = val 1.
Proof. intros H. cbn. field. exact H. Qed.

Lemma inverted (d e : expr) : val e <> zero -> val d = val e -> mul (val d) (val (1 / e)) = one.
Proof. intros H ->. exact (reciprocal e H). Qed.

(** A factor of what is not zero is not zero. *)

Lemma factor (a b c : expr) : val c <> zero -> val c = val (a * b) -> val a <> zero.
Proof. intros N E Z. apply N. rewrite E. cbn. rewrite Z. ring. Qed.

Lemma sum_value (a b : expr) : val (sum a b) = add (val a) (val b).
Proof.
  unfold sum; destruct a as [|[| |]| | | | |]; try (cbn; ring);
  destruct b as [|[| |]| | | | |]; cbn; ring.
Qed.

Lemma prod_value (a b : expr) : val (prod a b) = mul (val a) (val b).
Proof.
  unfold prod; destruct a as [|[|[| |]|]| | | | |]; try (cbn; ring);
  destruct b as [|[|[| |]|]| | | | |]; cbn; ring.
Qed.

Lemma quot_value (a b : expr) : val (quot a b) = div (val a) (val b).
Proof.
  assert (Z : forall x, div zero x = zero) by (intros; rewrite (Fdiv_def R_field); ring).
  assert (O : forall x, div x one = x) by (intros; field; exact (F_1_neq_0 R_field)).
  unfold quot; destruct a as [|[| |]| | | | |]; cbn [value integer_value]; auto;
  destruct b as [|[|[| |]|]| | | | |]; cbn [value integer_value positive_value]; auto.
Qed.

Lemma simple_value (e : expr) : val (simple e) = val e.
Proof.
  induction e as [n|z|a A b B|a A|a A b B|a A b B|a A n]; cbn [simple value]; trivial.
  - rewrite sum_value, A, B. reflexivity.
  - rewrite <- A. destruct (simple a) as [|[| |]| | | | |]; cbn; ring.
  - rewrite prod_value, A, B. reflexivity.
  - rewrite quot_value, A, B. reflexivity.
  - rewrite A. reflexivity.
Qed.

Lemma same_value (a : expr) : forall b, same a b = true -> val a = val b.
Proof.
  induction a as [n|z|a A b B|a A|a A b B|a A b B|a A n]; intros [m|y|c d|c|c d|c d|c m] H;
  cbn in H; try discriminate H; cbn [value];
  try (apply andb_prop in H; destruct H as [H1 H2]; rewrite (A _ H1);
       try rewrite (B _ H2); try rewrite (proj1 (Nat.eqb_eq _ _) H2); reflexivity).
  - rewrite (proj1 (Nat.eqb_eq _ _) H). reflexivity.
  - rewrite (proj1 (Z.eqb_eq _ _) H). reflexivity.
  - rewrite (A _ H). reflexivity.
Qed.

Fixpoint sound (known : table) : Prop :=
  match known with
  | [] => True
  | (b, c) :: rest => mul (val b) (val c) = one /\ sound rest
  end.

Lemma lookup_value (known : table) (b c : expr) :
  sound known -> lookup known b = Some c -> mul (val b) (val c) = one.
Proof.
  induction known as [|[d e] rest I]; cbn; intros S H; [discriminate H|].
  destruct S as [S T]. destruct (same (simple d) b) eqn:E.
  - injection H as <-. rewrite <- (same_value _ _ E), simple_value. exact S.
  - exact (I T H).
Qed.

Lemma inverse_value (known : table) (b : expr) :
  sound known -> forall c, inverse known b = Some c -> mul (val b) (val c) = one.
Proof.
  intros S. induction b as [n|z|a A b B|a A|a A b B|a A b B|a A n]; intros c H;
  cbn [inverse] in H;
  (destruct (lookup known _) as [d|] eqn:L;
   [injection H as <-; exact (lookup_value _ _ _ S L)|]); try discriminate H.
  - destruct z as [|[| |]|]; try discriminate H. injection H as <-. cbn. ring.
  - destruct (inverse known a) as [d|]; [|discriminate H]. injection H as <-. cbn [value].
    rewrite <- (A d eq_refl). ring.
  - destruct (inverse known a) as [d|]; [|discriminate H].
    destruct (inverse known b) as [e|]; [|discriminate H]. injection H as <-. cbn [value].
    transitivity (mul (mul (val a) (val d)) (mul (val b) (val e))); [ring|].
    rewrite (A d eq_refl), (B e eq_refl). ring.
  - destruct (inverse known a) as [d|]; [|discriminate H]. injection H as <-. cbn [value].
    exact (power_inverse _ _ _ (A d eq_refl)).
Qed.

Lemma undivided_value (known : table) (e : expr) :
  sound known -> val (undivided known e) = val e.
Proof.
  intros S. induction e as [n|z|a A b B|a A|a A b B|a A b B|a A n]; cbn [undivided];
  try (cbn [value]; congruence).
  destruct (inverse known b) as [c|] eqn:E; [|cbn [value]; congruence].
  rewrite prod_value, A. cbn [value]. symmetry.
  exact (quotient _ _ _ (inverse_value _ _ S _ E)).
Qed.

(** What has to be shown for two expressions to have the same value. *)

Lemma plainly (known : table) (a b : expr) :
  sound known -> val (plain known (a - b)) = zero -> val a = val b.
Proof.
  unfold plain. intros S H. rewrite (undivided_value _ _ S), simple_value in H.
  cbn [value Sub] in H.
  transitivity (add (add (val a) (opp (val b))) (val b)); [ring|]. rewrite H. ring.
Qed.

(** Combinations of equations that hold. *)

Fixpoint combination (terms : list (expr * (expr * expr))) : expr :=
  match terms with
  | [] => 0
  | (c, (a, b)) :: rest => c * (a - b) + combination rest
  end.

Fixpoint given (terms : list (expr * (expr * expr))) : Prop :=
  match terms with
  | [] => True
  | (_, (a, b)) :: rest => val a = val b /\ given rest
  end.

Lemma combined (terms : list (expr * (expr * expr))) (a b : expr) :
  given terms -> val (a - b) = val (combination terms) -> val a = val b.
Proof.
  intros G H. assert (Z : val (combination terms) = zero).
  { clear H. induction terms as [|[c [l r]] rest I]; [reflexivity|].
    destruct G as [E G]. cbn [combination value Sub]. rewrite E, (I G). ring. }
  rewrite Z in H. cbn [value Sub] in H.
  transitivity (add (add (val a) (opp (val b))) (val b)); [ring|]. rewrite H. ring.
Qed.

End Values.
